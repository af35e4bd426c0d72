// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   pqFFCancel
 * @brief   makes the button beside ParaView's progress bar cancel the Flip-Flop filters
 *
 * ParaView 5.11 draws that button but keeps it disabled while a pipeline runs, takes no input
 * meanwhile, and connects it to no filter. pqFFCancel enables it while a filter of Flip-Flop runs
 * in the built-in server, and sets the filter's AbortExecute when it is pressed.
 *
 * The press must be seen while the filter has the thread of the user interface. To process Qt's
 * events there would let anything happen within the run: a resized view renders, which updates the
 * very pipeline that is running. So no event of Qt's is processed. Instead a second connection to
 * the X server puts an invisible window (InputOnly) over the button for as long as the filter runs,
 * and each progress event asks that connection alone whether the window was pressed. All else that
 * the user does waits in Qt's own connection until the run is over, as it does without this class.
 *
 * What is cancelled is the filter that runs. Its output is empty, and counts as done: else the next
 * pass of the same Apply would run it again. The button Apply is enabled then, and runs it whole;
 * so does any change of the filter or of what it reads.
 *
 * Nothing is done where the server is remote or the window is not one of X.
 */

#ifndef pqFFCancel_h
#define pqFFCancel_h

#include "pqAutoStartInterface.h"
#include "vtkNew.h"         // For vtkNew
#include "vtkWeakPointer.h" // For vtkWeakPointer

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QScopedPointer>

class QAbstractButton;
class pqFFPressWatch;
class pqPipelineSource;
class vtkAlgorithm;
class vtkCallbackCommand;
class vtkObject;

class pqFFCancel
  : public QObject
  , public pqAutoStartInterface
{
  Q_OBJECT
  Q_INTERFACES(pqAutoStartInterface)

public:
  pqFFCancel(QObject* parent = nullptr);
  ~pqFFCancel() override;

  void startup() override;
  void shutdown() override;

private Q_SLOTS:
  /// Something may run now: see that the filters there are will be followed.
  void followFilters();

private:
  static void onEvent(vtkObject* caller, unsigned long event, void* self, void*);
  void onStart(vtkAlgorithm* filter);
  void onProgress(vtkAlgorithm* filter);
  void onEnd(vtkAlgorithm* filter);

  void offerCancel();
  void withdrawCancel();
  void offerApply(vtkAlgorithm* filter);

  vtkNew<vtkCallbackCommand> Observer;
  vtkWeakPointer<vtkAlgorithm> Running;
  QElapsedTimer SinceStart;
  bool Offered = false;
  bool Cancelled = false;
  QPointer<QAbstractButton> Button;
  QScopedPointer<pqFFPressWatch> Watch;
};

#endif
