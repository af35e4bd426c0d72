// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What ParaView asks of a plugin. paraview_add_plugin() would write this, but links all of
// ParaView's user interface, for which CMake then wants the development files of some ten more
// packages.

#define PARAVIEW_BUILDING_PLUGIN
#define PARAVIEW_PLUGIN_BUILT_SHARED 1
#include "vtkPVPlugin.h"

#include "pqFFCancel.h"
#include "pqFFLabelTips.h"

#include "vtkPVGUIPluginInterface.h"
#include "vtkPVPluginLoader.h"

namespace
{

class pqFFCancelPlugin
  : public vtkPVPlugin
  , public vtkPVGUIPluginInterface
{
public:
  // The loader closes plugins as well, and must not close this one twice.
  ~pqFFCancelPlugin() override { vtkPVPluginLoader::PluginLibraryUnloaded("FlipFlopCancel"); }

  const char* GetPluginName() override { return "FlipFlopCancel"; }
  const char* GetPluginVersionString() override { return FLIPFLOP_VERSION; }
  bool GetRequiredOnServer() override { return false; }
  bool GetRequiredOnClient() override { return true; }
  const char* GetRequiredPlugins() override { return ""; }
  const char* GetDescription() override
  {
    return "Cancel for the Flip-Flop filters, in the built-in server; icons, and tooltips of "
           "labels";
  }
  const char* GetEULA() override { return nullptr; }
  QObjectList interfaces() override { return { &this->Cancel }; }

private:
  pqFFCancel Cancel;
  pqFFLabelTips LabelTips;
};

}

PV_PLUGIN_EXPORT(FlipFlopCancel, pqFFCancelPlugin)
