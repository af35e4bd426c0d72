// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqFFCancel.h"

#include "pqFFPressWatch.h"

#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqPipelineSource.h"
#include "pqProgressManager.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkSMProxy.h"

#include <QTimer>
#include <QToolButton>
#include <QWidget>

namespace
{

/// Of shorter runs nobody could see the button.
constexpr qint64 MillisecondsUntilOffered = 200;

/// The filter of a source where it is one of ours in this very process, else null.
vtkAlgorithm* filterOf(const pqPipelineSource* source)
{
  if (source->getServer()->isRemote())
  {
    return nullptr;
  }
  auto* filter = vtkAlgorithm::SafeDownCast(source->getProxy()->GetClientSideObject());
  // By name: no library of the filters is linked to a plugin of the user interface.
  return filter && filter->IsA("vtkFFAlgorithm") ? filter : nullptr;
}

QList<pqPipelineSource*> allSources()
{
  return pqApplicationCore::instance()->getServerManagerModel()->findItems<pqPipelineSource*>();
}

}

//-----------------------------------------------------------------------------
pqFFCancel::pqFFCancel(QObject* parent)
  : QObject(parent)
  , Watch(new pqFFPressWatch)
{
  this->Observer->SetCallback(&pqFFCancel::onEvent);
  this->Observer->SetClientData(this);
}

//-----------------------------------------------------------------------------
pqFFCancel::~pqFFCancel()
{
  // Filters that outlive this keep the observer.
  this->Observer->SetCallback(nullptr);
}

//-----------------------------------------------------------------------------
void pqFFCancel::startup()
{
  // Once for each pass of a pipeline: filters that a state file, a script or another menu has made
  // are found, too, when they first run.
  QObject::connect(pqApplicationCore::instance()->getProgressManager(),
    &pqProgressManager::progressStartEvent, this, &pqFFCancel::followFilters);
}

//-----------------------------------------------------------------------------
void pqFFCancel::shutdown()
{
  this->Observer->SetCallback(nullptr);
  this->withdrawCancel();
}

//-----------------------------------------------------------------------------
void pqFFCancel::followFilters()
{
  for (const pqPipelineSource* source : allSources())
  {
    vtkAlgorithm* filter = filterOf(source);
    if (filter && !filter->HasObserver(vtkCommand::ProgressEvent, this->Observer))
    {
      filter->AddObserver(vtkCommand::StartEvent, this->Observer);
      filter->AddObserver(vtkCommand::ProgressEvent, this->Observer);
      filter->AddObserver(vtkCommand::EndEvent, this->Observer);
    }
  }
}

//-----------------------------------------------------------------------------
void pqFFCancel::onEvent(vtkObject* caller, unsigned long event, void* self, void*)
{
  auto* cancel = static_cast<pqFFCancel*>(self);
  auto* filter = static_cast<vtkAlgorithm*>(caller);
  switch (event)
  {
    case vtkCommand::StartEvent:
      cancel->onStart(filter);
      break;
    case vtkCommand::ProgressEvent:
      cancel->onProgress(filter);
      break;
    case vtkCommand::EndEvent:
      cancel->onEnd(filter);
      break;
  }
}

//-----------------------------------------------------------------------------
void pqFFCancel::onStart(vtkAlgorithm* filter)
{
  this->withdrawCancel();
  this->Running = filter;
  this->SinceStart.start();
}

//-----------------------------------------------------------------------------
void pqFFCancel::onProgress(vtkAlgorithm* filter)
{
  if (filter != this->Running || this->Cancelled)
  {
    return;
  }
  if (!this->Offered && this->SinceStart.elapsed() >= MillisecondsUntilOffered)
  {
    this->offerCancel();
  }
  if (this->Watch->pressed())
  {
    this->Cancelled = true;
    // Not by SetAbortExecute(), which is a modification: the filter would run again.
    filter->AbortExecute = 1;
    if (this->Button)
    {
      this->Button->setDown(true);
      this->Button->repaint();
    }
  }
}

//-----------------------------------------------------------------------------
void pqFFCancel::onEnd(vtkAlgorithm* filter)
{
  if (filter != this->Running)
  {
    return;
  }
  if (this->Cancelled)
  {
    // Whatever asks for the output next gets the empty one.
    filter->AbortExecute = 0;
    filter->SetAbortOutput(false);
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      filter->GetOutputInformation(port)->Remove(vtkAlgorithm::ABORTED());
    }
    this->offerApply(filter);
  }
  this->withdrawCancel();
}

//-----------------------------------------------------------------------------
void pqFFCancel::offerCancel()
{
  this->Offered = true;
  this->Button = pqCoreUtilities::mainWidget()
    ? pqCoreUtilities::mainWidget()->findChild<QToolButton*>("AbortButton")
    : nullptr;
  if (this->Button && this->Watch->begin(this->Button))
  {
    pqApplicationCore::instance()->getProgressManager()->setEnableAbort(true);
    this->Button->repaint();
  }
}

//-----------------------------------------------------------------------------
void pqFFCancel::withdrawCancel()
{
  this->Watch->end();
  if (this->Offered && pqApplicationCore::instance())
  {
    pqApplicationCore::instance()->getProgressManager()->setEnableAbort(false);
  }
  if (this->Button)
  {
    this->Button->setDown(false);
  }
  this->Button = nullptr;
  this->Running = nullptr;
  this->Offered = false;
  this->Cancelled = false;
}

//-----------------------------------------------------------------------------
void pqFFCancel::offerApply(vtkAlgorithm* filter)
{
  for (pqPipelineSource* source : allSources())
  {
    if (filterOf(source) != filter)
    {
      continue;
    }
    // Once the Apply that is running is over, which takes its own mark away.
    QPointer<pqPipelineSource> cancelled(source);
    QTimer::singleShot(0, this,
      [cancelled]
      {
        if (!cancelled)
        {
          return;
        }
        if (cancelled->modifiedState() == pqProxy::UNMODIFIED)
        {
          cancelled->setModifiedState(pqProxy::MODIFIED);
        }
        auto* listener = new QObject(cancelled); // for one Apply
        QObject::connect(cancelled, &pqProxy::modifiedStateChanged, listener,
          [cancelled, listener]
          {
            if (cancelled->modifiedState() != pqProxy::UNMODIFIED)
            {
              return;
            }
            listener->deleteLater();
            if (vtkAlgorithm* again = filterOf(cancelled))
            {
              again->Modified();
              // So that what is shown of it asks for its output anew.
              cancelled->getProxy()->MarkDirty(cancelled->getProxy());
            }
          });
      });
  }
}
