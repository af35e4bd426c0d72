// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DeviceInputs.h"

#include "Testing/Engine/Inputs/InputsInUse.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <algorithm>
#include <limits>
#include <random>
#include <utility>

namespace flipflop
{
namespace test
{

namespace
{

constexpr std::uint64_t Seed = 2013;

DeviceInput space(Coordinates xyz)
{
  DeviceInput input;
  input.xyz = std::move(xyz);
  return input;
}

DeviceInput plane(Coordinates xyw, bool weighted)
{
  DeviceInput input;
  input.xyz = std::move(xyw);
  input.plane = true;
  input.weighted = weighted;
  return input;
}

/// Every axis by a factor of its own.
DeviceInput scaled(DeviceInput input, double x, double y, double z)
{
  const double factors[3] = { x, y, z };
  for (std::size_t i = 0; i < input.xyz.size(); ++i)
  {
    input.xyz[i] *= factors[i % 3];
  }
  return input;
}

/// The first @p count points of a list in general position.
Coordinates few(std::size_t count)
{
  const double all[] = { 0, 0, 0, 3, 0, 1, 0, 4, 2, 1, 1, 5, 2, 3, 4 };
  return Coordinates(all, all + 3 * count);
}

Coordinates coordinatesOf(const Cloud& cloud)
{
  Coordinates xyz;
  xyz.reserve(3 * cloud.size());
  for (const Point& p : cloud)
  {
    xyz.insert(xyz.end(), p.begin(), p.end());
  }
  return xyz;
}

Coordinates cocircular(int square, double weight)
{
  Cloud cloud = cocircularIntegers(square);
  for (Point& p : cloud)
  {
    p[2] = weight;
  }
  return coordinatesOf(cloud);
}

DeviceInput onLine(std::int64_t count)
{
  Coordinates xyz;
  for (std::int64_t i = 0; i < count; ++i)
  {
    const auto t = static_cast<double>(i * 37 % count);
    xyz.insert(xyz.end(), { t, 2 * t, -t });
  }
  return space(std::move(xyz));
}

/// A sheet, and one point beside it: the hull is a pyramid.
DeviceInput sheet(std::int64_t side, bool apex)
{
  Coordinates xyz;
  for (std::int64_t i = 0; i < side * side; ++i)
  {
    xyz.insert(xyz.end(), { static_cast<double>(i % side), static_cast<double>(i / side), 0 });
  }
  if (apex)
  {
    xyz.insert(xyz.end(), { 1, 1, 7 });
  }
  return space(std::move(xyz));
}

/// Every coordinate a float's.
DeviceInput rounded(DeviceInput input)
{
  for (double& x : input.xyz)
  {
    x = static_cast<float>(x);
  }
  return input;
}

/// Every seventh point is not finite.
DeviceInput withNonFinite(DeviceInput input)
{
  const double bad[] = { std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
  const std::size_t axes = input.plane && !input.weighted ? 2 : 3;
  for (std::size_t i = 0; 21 * i < input.xyz.size(); ++i)
  {
    input.xyz[21 * i + i % axes] = bad[i % 3];
  }
  return input;
}

/// Points whose lengths no scaling brings together.
DeviceInput ofAllSizes(DeviceInput input, double least, double most)
{
  for (std::size_t i = 0; i < input.xyz.size(); ++i)
  {
    const std::size_t kind = i / 3 % 3;
    const bool weight = input.plane && i % 3 == 2;
    input.xyz[i] *= weight ? 0 : kind == 0 ? most : kind == 1 ? least : 1;
  }
  return input;
}

/// Points that appear, and heavy ones that hide most of them.
DeviceInput hiding(std::int64_t count)
{
  DeviceInput input = drawn("uniformLight", true, count);
  for (std::size_t i = 0; i < input.xyz.size(); i += 3)
  {
    input.xyz[i + 2] = i % 300 == 0 ? 0.01 : -0.5 * input.xyz[i + 2];
  }
  return input;
}

}

RunInput DeviceInput::view() const
{
  const auto count = static_cast<std::int64_t>(this->xyz.size() / 3);
  RunInput input;
  input.plane = this->plane;
  input.points = PointView(this->xyz.data(), count);
  if (this->weighted)
  {
    // Where there is no point, there is no weight, but weights are given all the same.
    static const double none = 0;
    input.weights = WeightView(count ? this->xyz.data() + 2 : &none, count, 3);
  }
  return input;
}

DeviceInput drawn(const std::string& family, bool plane, std::int64_t count)
{
  const Cloud cloud = makeCloud(family, plane, static_cast<int>(count), Seed);
  DeviceInput input;
  input.xyz = coordinatesOf(cloud);
  input.plane = plane;
  input.weighted =
    plane && std::any_of(cloud.begin(), cloud.end(), [](const Point& p) { return p[2] != 0; });
  return input;
}

std::vector<InputMaker> deviceInputs()
{
  std::vector<InputMaker> all;
  const auto add = [&all](const std::string& name, bool small, std::function<DeviceInput()> make) {
    all.push_back({ name, small, false, false, std::move(make) });
  };
  const auto addDrawn = [&](const char* label, bool inPlane, std::int64_t count)
  {
    add(std::string(inPlane ? "plane-" : "") + label + "-" + std::to_string(count), count <= 1000,
      [=] { return drawn(label, inPlane, count); });
  };

  for (std::size_t n = 0; n <= 5; ++n)
  {
    add("few-" + std::to_string(n), n >= 4, [n] { return space(few(n)); });
    add("plane-few-" + std::to_string(n), n >= 3, [n] { return plane(few(n), false); });
    add("plane-few-weighted-" + std::to_string(n), n >= 4, [n] { return plane(few(n), true); });
  }
  for (const char* label : { "cube", "ball", "shell1e2", "shell0", "rotated-grid", "duplicates" })
  {
    addDrawn(label, false, 100);
    addDrawn(label, false, 10000);
  }
  addDrawn("cube-grid", false, 1000);
  addDrawn("cube-grid", false, 100000);
  addDrawn("surface-grid", false, 1000);
  addDrawn("surface-grid", false, 50000);
  addDrawn("boxShell", false, 100000);
  addDrawn("shell1e4", false, 100000);
  addDrawn("shell0", false, 200000);
  addDrawn("cube", false, 1000000);
  addDrawn("shell1e2", false, 1000000);
  add("one-position", true, [] { return space(Coordinates(300, 1.5)); });
  add("collinear", true, [] { return onLine(1000); });
  add("coplanar", true, [] { return sheet(30, false); });
  add("pyramid-on-a-sheet", true, [] { return sheet(30, true); });
  add("cospherical-101", true, [] { return space(coordinatesOf(cosphericalIntegers(101))); });
  add("cospherical-5525", false, [] { return space(coordinatesOf(cosphericalIntegers(5525))); });
  add("tiny", true, [] { return scaled(drawn("ball", false, 500), 1e-300, 1e-300, 1e-300); });
  add("huge", true, [] { return scaled(drawn("ball", false, 500), 1e300, 1e300, 1e300); });
  add(
    "flat-but-not-quite", true, [] { return scaled(drawn("shell0", false, 800), 1, 1, 0x1p-40); });
  add("floats", false, [] { return rounded(drawn("shell1e2", false, 20000)); });

  for (const char* label : { "uniform", "uniformLight", "uniformHeavy", "grid", "gridOfOneWeight",
         "circle", "hundred-normals", "scan" })
  {
    addDrawn(label, true, 400);
    addDrawn(label, true, 20000);
  }
  addDrawn("uniformHeavy", true, 200000);
  addDrawn("uniform", true, 500000);
  addDrawn("uniformHeavy", true, 1000000);
  add("plane-cocircular", true, [] { return plane(cocircular(5525, 0), false); });
  add("plane-cocircular-weighted", true, [] { return plane(cocircular(27625, 2), true); });
  add("plane-collinear", true,
    []
    {
      DeviceInput line = onLine(500);
      line.plane = true;
      return line;
    });
  add("plane-hiding", false, [] { return hiding(30000); });
  add("plane-tiny", true,
    [] { return scaled(drawn("uniformHeavy", true, 400), 1e-150, 1e-150, 1e-300); });
  add("plane-huge", true,
    [] { return scaled(drawn("uniformHeavy", true, 400), 1e150, 1e150, 1e300); });

  const auto addSpecial = [&all](
                            const std::string& name, bool wide, std::function<DeviceInput()> make) {
    all.push_back({ name, !wide, wide, !wide, std::move(make) });
  };
  addSpecial("wide", true, [] { return ofAllSizes(drawn("ball", false, 60), 1e-300, 1e300); });
  addSpecial(
    "plane-wide", true, [] { return ofAllSizes(drawn("uniform", true, 60), 1e-150, 1e150); });
  addSpecial("non-finite", false, [] { return withNonFinite(drawn("shell1e2", false, 1000)); });
  addSpecial(
    "plane-non-finite", false, [] { return withNonFinite(drawn("uniformHeavy", true, 1000)); });
  return all;
}

}
}
