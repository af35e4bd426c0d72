// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShapesInUse.h"

#include "Shapes.h"

#include <stdexcept>

namespace flipflop
{
namespace
{

const std::string Shuffled = "-shuffled";

bool isShuffled(const std::string& name)
{
  return name.size() > Shuffled.size() &&
    name.compare(name.size() - Shuffled.size(), Shuffled.size(), Shuffled) == 0;
}

/// Of a name with or without the ending; null where there is none.
const Shape* find(const std::string& name)
{
  const std::string plain = isShuffled(name) ? name.substr(0, name.size() - Shuffled.size()) : name;
  for (const auto* list : { &drawingShapes(), &surveyShapes(), &spaceShapes() })
  {
    for (const Shape& shape : *list)
    {
      if (shape.name == plain)
      {
        return &shape;
      }
    }
  }
  return nullptr;
}

}

std::vector<std::string> shapesInUse(bool space)
{
  using Lists = std::vector<const std::vector<Shape>*>;
  std::vector<std::string> names;
  for (const auto* list :
    space ? Lists{ &spaceShapes() } : Lists{ &drawingShapes(), &surveyShapes() })
  {
    for (const Shape& shape : *list)
    {
      names.emplace_back(shape.name);
    }
  }
  return names;
}

std::vector<std::string> withShuffled(const std::vector<std::string>& names)
{
  std::vector<std::string> both;
  for (const std::string& name : names)
  {
    both.push_back(name);
    both.push_back(name + Shuffled);
  }
  return both;
}

bool isWeightedShape(const std::string& name)
{
  const Shape* shape = find(name);
  return shape && shape->weighted;
}

Coordinates makeShapeInUse(const std::string& name, std::int64_t count, std::uint64_t seed)
{
  const Shape* shape = find(name);
  if (!shape)
  {
    throw std::invalid_argument("unknown shape: " + name);
  }
  RandomPoints random(seed);
  Coordinates points = shape->make(random, count);
  if (isShuffled(name))
  {
    shuffle(random, points);
  }
  return points;
}

}
