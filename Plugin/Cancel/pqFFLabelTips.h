// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   pqFFLabelTips
 * @brief   the tooltips of the labels in the panels of the Flip-Flop filters
 *
 * ParaView explains a property where the pointer is over its field, but not over its label, which
 * is what one points at to learn what it means. This shows the field's tooltip there, too. Panels
 * of other filters stay as they are.
 */

#ifndef pqFFLabelTips_h
#define pqFFLabelTips_h

#include <QObject>

class pqFFLabelTips : public QObject
{
  Q_OBJECT

public:
  /// Watches the application's events from now on.
  pqFFLabelTips();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

#endif
