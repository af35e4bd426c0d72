# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""
The modules of PyQt for the Qt that this process has: PyQt5 or PyQt6. The other would bring a second Qt with it.

Name enumerators by their enumeration (Qt.MouseButton.LeftButton): PyQt6 takes no other, and PyQt5 takes that, too.
"""
with open("/proc/self/maps") as maps:
    six = "libQt6Core" in maps.read()

if six:
    from PyQt6 import QtCore, QtGui, QtTest, QtWidgets, sip
else:
    from PyQt5 import QtCore, QtGui, QtTest, QtWidgets, sip

__all__ = ["QtCore", "QtGui", "QtTest", "QtWidgets", "sip", "six"]
