// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFFailure.h"

#include "FFErrorTexts.h"
#include "FFExactValues.h"

#include <flipflop/Engines.h>
#include <flipflop/Error.h>
#include <flipflop/Weights.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <exception>
#include <iterator>
#include <new>
#include <sstream>
#include <stdexcept>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

std::string capitalized(std::string text)
{
  text[0] = static_cast<char>(std::toupper(text[0]));
  return text;
}

using flipflop::ErrorCode;

static_assert(static_cast<int>(FFErrorKind::Setting) + vtkErrorCode::UserError ==
      vtkFFErrorCode::SettingError &&
    static_cast<int>(FFErrorKind::Internal) + vtkErrorCode::UserError ==
      vtkFFErrorCode::InternalError,
  "the kinds are in the order of the codes");

constexpr const char* noMemory = "There is not enough memory for this input.";

/// The failure that an error of the engine is; @p of says which data set has it.
FFFailure failureOf(const flipflop::Error& error, const std::string& of)
{
  FFFailure failure;
  const auto* const found = std::find_if(std::begin(FFErrorTexts), std::end(FFErrorTexts),
    [&](const FFErrorText& text) { return text.Code == error.code(); });
  if (found == std::end(FFErrorTexts))
  {
    failure.Say(error.what());
    return failure;
  }
  const std::pair<const char*, std::string> parts[] = { { "{index}",
                                                          std::to_string(error.index()) },
    { "{count}", std::to_string(error.count()) }, { "{of}", of },
    { "{text}",
      error.code() == ErrorCode::NoDevice ? flipflop::cudaStatus().problem : error.what() } };
  std::string message = found->Text;
  for (const auto& [name, value] : parts)
  {
    const std::size_t begin = message.find(name);
    if (begin != std::string::npos)
    {
      message.replace(begin, std::strlen(name), value);
    }
  }
  failure.Say(message, static_cast<unsigned long>(found->Kind) + vtkErrorCode::UserError);
  return failure;
}

}

//------------------------------------------------------------------------------
FFFailure FFFailure::OfException(const std::function<vtkIdType(vtkIdType)>& idOf,
  const std::function<std::string(vtkIdType)>& where, const std::string& of)
{
  FFFailure failure;
  const auto pointAt = [&](auto index) { return where(idOf(static_cast<vtkIdType>(index))); };
  try
  {
    throw;
  }
  catch (const flipflop::BadWeight& error)
  {
    failure.Say(capitalized(error.what()) + ": first at " + pointAt(error.index()) +
      (error.fault() == flipflop::BadWeight::Fault::NegativeRadius
          ? ". Radii are lengths. If the array has weights, which may be negative, set Weight Mode "
            "to Weights."
          : ". Use another unit of length, or a smaller factor."));
  }
  catch (const flipflop::Error& error)
  {
    if (error.code() == ErrorCode::NonFinite)
    {
      failure.Kind = NonFinite;
      failure.Point = idOf(static_cast<vtkIdType>(error.index()));
      failure.Count = static_cast<vtkIdType>(error.count());
    }
    else if (error.code() == ErrorCode::Aborted)
    {
      failure.Kind = Aborted;
    }
    else if (error.code() == ErrorCode::OutOfMemory && error.count() <= 0)
    {
      failure.Say(noMemory, vtkFFErrorCode::MemoryError);
    }
    else
    {
      failure = failureOf(error, of);
    }
  }
  catch (const FFInexactValue& error)
  {
    failure.Say(error.Describe(pointAt(error.GetIndex())));
  }
  catch (const FFBadSetting& error)
  {
    failure.Say(error.what(), vtkFFErrorCode::SettingError);
  }
  catch (const FFBadConstraint& error)
  {
    failure.Say(error.what(), vtkFFErrorCode::ConstraintError);
  }
  catch (const std::bad_alloc&)
  {
    failure.Say(noMemory, vtkFFErrorCode::MemoryError);
  }
  catch (const std::runtime_error& error)
  {
    failure.Say(error.what());
  }
  catch (const std::exception& error)
  {
    failure.Say(error.what(), vtkFFErrorCode::InternalError);
  }
  catch (...)
  {
    failure.Say("The engine failed for an unknown reason.", vtkFFErrorCode::InternalError);
  }
  return failure;
}

//------------------------------------------------------------------------------
void FFFailure::CheckLength(double length, const char* name, const char* zero)
{
  if (!(length >= 0.0))
  {
    std::ostringstream message;
    message << name << " is " << length << "; it must be a length, or 0 for " << zero << ".";
    throw FFBadSetting(message.str());
  }
}
VTK_ABI_NAMESPACE_END
