// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DeviceInputs.h"

#include "Testing/Engine/Inputs/InputsInUse.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <algorithm>
#include <utility>

namespace flipflop
{
namespace test
{

namespace
{

constexpr std::uint64_t Seed = 2013;

DeviceInput inputOf(const Cloud& cloud, bool plane)
{
  DeviceInput input;
  input.xyz.reserve(3 * cloud.size());
  for (const Point& p : cloud)
  {
    input.xyz.insert(input.xyz.end(), p.begin(), p.end());
  }
  input.plane = plane;
  input.weighted =
    plane && std::any_of(cloud.begin(), cloud.end(), [](const Point& p) { return p[2] != 0; });
  return input;
}

/// Points whose lengths no scaling brings together.
Cloud ofAllSizes(Cloud cloud, double least, double most, bool plane)
{
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    const double factor = i % 3 == 0 ? most : i % 3 == 1 ? least : 1;
    cloud[i] = { factor * cloud[i][0], factor * cloud[i][1], plane ? 0 : factor * cloud[i][2] };
  }
  return cloud;
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
    input.weights = WeightView(this->xyz.data() + 2, count, 3);
  }
  return input;
}

DeviceInput drawn(const std::string& family, bool plane, std::int64_t count)
{
  return inputOf(makeCloud(family, plane, static_cast<int>(count), Seed), plane);
}

std::vector<InputMaker> deviceInputs()
{
  std::vector<InputMaker> all;
  const auto add = [&all](bool plane, const std::string& name, bool small,
                     std::function<Cloud()> make, bool wide = false, bool nonFinite = false)
  {
    all.push_back({ (plane ? "plane-" : "") + name, small, wide, nonFinite,
      [=] { return inputOf(make(), plane); } });
  };
  const auto addDrawn = [&](bool plane, const char* label, int count)
  {
    add(plane, label + ("-" + std::to_string(count)), count <= 1000,
      [=] { return makeCloud(label, plane, count, Seed); });
  };

  for (const bool plane : { false, true })
  {
    int count = 250; // and many, in turns
    for (const Family& family : plane ? weightedFamilies() : families())
    {
      addDrawn(plane, family.name, count);
      count = count == 250 ? 10000 : 250;
    }
    for (const bool small : { true, false })
    {
      const std::vector<Input> inputs = plane
        ? small ? smallWeightedInputs() : largeWeightedInputs()
        : small ? smallSpecialInputs()
                : largeSpecialInputs();
      for (const Input& input : inputs)
      {
        add(plane, input.name + (small ? "-special" : "-special-large"), false, input.make);
      }
    }
    const Cloud five = { { 0, 0, 0 }, { 3, 0, 1 }, { 0, 4, 2 }, { 1, 1, 5 }, { 2, 3, 4 } };
    for (int n = 0; n <= 5; ++n)
    {
      add(plane, "few-" + std::to_string(n), n >= 4, [=] { return Cloud(&five[0], &five[0] + n); });
    }
    add(plane, "one-position", true, [] { return Cloud(100, { 1.5, 1.5, 1.5 }); });
    add(
      plane, "wide", false,
      [=]
      {
        const Cloud cloud = makeCloud(plane ? "uniform" : "ball", plane, 60, Seed);
        return plane ? ofAllSizes(cloud, 1e-150, 1e150, true)
                     : ofAllSizes(cloud, 1e-300, 1e300, false);
      },
      true);
    add(
      plane, "non-finite", true,
      [=]
      {
        Random random(Seed);
        std::vector<std::int64_t> places;
        return withNonFinite(
          makeCloud(plane ? "uniformHeavy" : "shell1e2", plane, 1000, Seed), random, places);
      },
      false, true);
  }
  // So few duplicates that filters leave them open in the middle of growing, when the others are
  // ordered; and so many that the sample from which a run starts has not the lowest id of each.
  for (const std::size_t step : { 10, 25 })
  {
    add(false, "few-duplicates-" + std::to_string(step), true,
      [step]
      {
        Cloud cloud = fromFamily("shell0", 4000, step).make();
        for (std::size_t i = 0; i < 4000; i += step)
        {
          cloud.push_back(cloud[i]);
        }
        return cloud;
      });
  }
  add(false, "many-duplicates", true,
    []
    {
      Random random(Seed);
      return repeated(integerGrid(3), 100, random);
    });
  add(false, "many-duplicates-of-a-sphere", true,
    []
    {
      Random random(Seed);
      return repeated(fromFamily("shell0", 30, 7).make(), 100, random);
    });
  for (const char* label : { "rotated-grid", "duplicates", "cube-grid", "surface-grid" })
  {
    addDrawn(false, label, 1000);
    addDrawn(false, label, 50000);
  }
  addDrawn(false, "shell0", 200000);
  addDrawn(false, "cube", 1000000);
  addDrawn(false, "shell1e2", 1000000);
  for (const char* label : { "hundred-normals", "scan" })
  {
    addDrawn(true, label, 400);
    addDrawn(true, label, 20000);
  }
  addDrawn(true, "uniform", 500000);
  addDrawn(true, "uniformHeavy", 1000000);
  return all;
}

}
}
