// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   pqFFPressWatch
 * @brief   whether a widget was pressed, told without processing any of Qt's events
 *
 * An invisible window over the widget takes the pointer's presses, for a connection to the X server
 * that is not Qt's. It lies within the widget's own top-level window, so it moves along with that,
 * and what covers that covers it.
 */

#ifndef pqFFPressWatch_h
#define pqFFPressWatch_h

#include <cstdint>

class QWidget;
struct xcb_connection_t;

class pqFFPressWatch
{
public:
  pqFFPressWatch() = default;
  ~pqFFPressWatch();
  pqFFPressWatch(const pqFFPressWatch&) = delete;
  void operator=(const pqFFPressWatch&) = delete;

  /// Begin to watch a widget; false where that cannot be done.
  bool begin(const QWidget* widget);
  void end();

  /// Whether the primary button was pressed on the widget since the last call.
  bool pressed();

private:
  xcb_connection_t* Connection = nullptr;
  std::uint32_t Window = 0;
};

#endif
