// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqFFLabelTips.h"

#include "pqProxyWidget.h"

#include "vtkSMProxy.h"

#include <QApplication>
#include <QGridLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QToolTip>

#include <cstring>

namespace
{

bool isOurs(vtkSMProxy* proxy)
{
  const char* name = proxy ? proxy->GetVTKClassName() : nullptr;
  return name && (std::strncmp(name, "vtkFF", 5) == 0 || std::strncmp(name, "vtkPFF", 6) == 0);
}

/// The tooltip of what stands beside the label in the panel's grid.
QString tipBeside(QLabel* label)
{
  auto* panel = qobject_cast<pqProxyWidget*>(label->parentWidget());
  auto* grid = panel ? qobject_cast<QGridLayout*>(panel->layout()) : nullptr;
  const int index = grid ? grid->indexOf(label) : -1;
  if (index < 0 || !isOurs(panel->proxy()))
  {
    return {};
  }
  int row = 0;
  int column = 0;
  int rows = 0;
  int columns = 0;
  grid->getItemPosition(index, &row, &column, &rows, &columns);
  QLayoutItem* field = grid->itemAtPosition(row, column + columns);
  return field && field->widget() ? field->widget()->toolTip() : QString();
}

}

//------------------------------------------------------------------------------
pqFFLabelTips::pqFFLabelTips()
{
  qApp->installEventFilter(this);
}

//------------------------------------------------------------------------------
bool pqFFLabelTips::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() == QEvent::ToolTip)
  {
    auto* label = qobject_cast<QLabel*>(watched);
    const QString tip = label && label->toolTip().isEmpty() ? tipBeside(label) : QString();
    if (!tip.isEmpty())
    {
      QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), tip, label);
      return true;
    }
  }
  return this->QObject::eventFilter(watched, event);
}
