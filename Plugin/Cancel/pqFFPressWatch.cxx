// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqFFPressWatch.h"

#include <QGuiApplication>
#include <QPoint>
#include <QWidget>

#include <xcb/xcb.h>

#include <cstdlib>

//-----------------------------------------------------------------------------
pqFFPressWatch::~pqFFPressWatch()
{
  if (this->Connection)
  {
    xcb_disconnect(this->Connection); // the window goes with it
  }
}

//-----------------------------------------------------------------------------
bool pqFFPressWatch::begin(const QWidget* widget)
{
  this->end();
  // internalWinId(): a window that is not there yet must not be made here.
  if (QGuiApplication::platformName() != "xcb" || !widget->isVisible() ||
    !widget->window()->internalWinId())
  {
    return false;
  }
  if (this->Connection && xcb_connection_has_error(this->Connection))
  {
    xcb_disconnect(this->Connection);
    this->Connection = nullptr;
  }
  if (!this->Connection)
  {
    this->Connection = xcb_connect(nullptr, nullptr);
    if (xcb_connection_has_error(this->Connection))
    {
      return false;
    }
  }
  // X counts the screen's pixels, Qt those of a screen of usual resolution.
  const double scale = widget->devicePixelRatioF();
  const QPoint corner = widget->mapTo(widget->window(), QPoint(0, 0)) * scale;
  const QSize size = widget->size() * scale;
  const std::uint32_t events = XCB_EVENT_MASK_BUTTON_PRESS;
  const xcb_window_t window = xcb_generate_id(this->Connection);
  xcb_generic_error_t* error = xcb_request_check(this->Connection,
    xcb_create_window_checked(this->Connection, XCB_COPY_FROM_PARENT, window,
      static_cast<xcb_window_t>(widget->window()->internalWinId()),
      static_cast<std::int16_t>(corner.x()), static_cast<std::int16_t>(corner.y()),
      static_cast<std::uint16_t>(size.width()), static_cast<std::uint16_t>(size.height()), 0,
      XCB_WINDOW_CLASS_INPUT_ONLY, XCB_COPY_FROM_PARENT, XCB_CW_EVENT_MASK, &events));
  if (error)
  {
    std::free(error);
    return false;
  }
  this->Window = window;
  xcb_map_window(this->Connection, window);
  xcb_flush(this->Connection);
  return true;
}

//-----------------------------------------------------------------------------
void pqFFPressWatch::end()
{
  if (!this->Window)
  {
    return;
  }
  // Checked, so that it is gone for certain: no press that comes from now on is lost to it. An
  // error says that it went with its parent.
  std::free(xcb_request_check(
    this->Connection, xcb_destroy_window_checked(this->Connection, this->Window)));
  while (xcb_generic_event_t* event = xcb_poll_for_event(this->Connection))
  {
    std::free(event); // too late for the run, and not meant for the next
  }
  this->Window = 0;
}

//-----------------------------------------------------------------------------
bool pqFFPressWatch::pressed()
{
  bool found = false;
  if (!this->Window)
  {
    return found;
  }
  while (xcb_generic_event_t* event = xcb_poll_for_event(this->Connection))
  {
    // The highest bit tells of events that another client has sent.
    if ((event->response_type & 0x7f) == XCB_BUTTON_PRESS)
    {
      const auto* press = reinterpret_cast<const xcb_button_press_event_t*>(event);
      found = found || (press->event == this->Window && press->detail == XCB_BUTTON_INDEX_1);
    }
    std::free(event);
  }
  return found;
}
