// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFStreamedBlocks.h"

#include "vtkFFPointRegions.h"

#include <flipflop/Error.h>

// DIY without MPI has other types behind the same names, so it gets a namespace of its own here.
#include "vtk_diy2.h"
#undef diy
#define diy vtkffdiy
#ifndef DIY_NO_MPI
#define DIY_NO_MPI
#endif
#if VTK_MODULE_USE_EXTERNAL_vtkdiy2
#include <diy/master.hpp>
#else
#include <vtkdiy2/include/vtkdiy2/master.hpp>
#endif

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <random>
#include <stdexcept>
#include <string_view>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using Settings = vtkFFStreamedBlocks::SettingsType;

/// In bytes: smaller messages between blocks wait in memory.
constexpr std::size_t LargeMessage = std::size_t(1) << 20;

/// As blocks are dealt it.
struct Point
{
  double Position[3];
  std::int64_t Id;
};

/// The first failure of any thread: DIY's threads must not be left by an exception.
class SharedFailure
{
public:
  void Note(std::exception_ptr error)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Error = this->Error ? this->Error : std::move(error);
    this->Any = true;
  }
  void Note(const char* message)
  {
    this->Note(std::make_exception_ptr(std::runtime_error(message)));
  }
  bool IsThere() const { return this->Any; }
  void Throw() const
  {
    if (this->Any)
    {
      std::rethrow_exception(this->Error);
    }
  }

private:
  std::mutex Mutex;
  std::exception_ptr Error;
  std::atomic<bool> Any{ false };
};

std::size_t hashOf(const std::vector<char>& bytes)
{
  return std::hash<std::string_view>()({ bytes.data(), bytes.size() });
}

/// Bytes that wait in a file: of a block, or of some of its points. DIY does not check what becomes
/// of a file; so this does.
struct Waiting
{
  SharedFailure* Failure = nullptr;
  std::vector<char> Bytes;
  std::vector<int> Chunks; ///< the files with a block's points, until it is made

  static void* Create() { return new Waiting; }
  static void Destroy(void* self) { delete static_cast<Waiting*>(self); }

  struct Head
  {
    SharedFailure* Failure;
    std::size_t Bytes, Chunks, Hash;
  };
  static void Save(const void* self, diy::BinaryBuffer& buffer)
  {
    const auto& waiting = *static_cast<const Waiting*>(self);
    const Head head{ waiting.Failure, waiting.Bytes.size(), waiting.Chunks.size(),
      hashOf(waiting.Bytes) };
    buffer.save_binary(reinterpret_cast<const char*>(&head), sizeof(head));
    buffer.save_binary(
      reinterpret_cast<const char*>(waiting.Chunks.data()), waiting.Chunks.size() * sizeof(int));
    buffer.save_binary(waiting.Bytes.data(), waiting.Bytes.size());
    auto* const file = dynamic_cast<diy::detail::FileBuffer*>(&buffer);
    if (file && (std::fflush(file->file) != 0 || std::ferror(file->file)))
    {
      waiting.Failure->Note("A block cannot be written to the folder: it may be full.");
    }
  }

  static void Load(void* self, diy::BinaryBuffer& buffer)
  {
    auto& waiting = *static_cast<Waiting*>(self);
    Head head{};
    buffer.load_binary(reinterpret_cast<char*>(&head), sizeof(head));
    waiting.Failure = head.Failure;
    if (!head.Failure || head.Failure->IsThere())
    {
      return;
    }
    try
    {
      waiting.Chunks.resize(head.Chunks);
      waiting.Bytes.resize(head.Bytes);
      buffer.load_binary(reinterpret_cast<char*>(waiting.Chunks.data()), head.Chunks * sizeof(int));
      buffer.load_binary(waiting.Bytes.data(), head.Bytes);
      if (hashOf(waiting.Bytes) != head.Hash)
      {
        waiting.Failure->Note("A block's file has changed while the block waited.");
      }
    }
    catch (...)
    {
      waiting.Failure->Note(std::current_exception());
    }
  }
};

/// A folder for files, which goes with all that it has.
class OwnFolder
{
public:
  explicit OwnFolder(const std::string& parent)
  {
    std::random_device device;
    std::error_code error;
    for (int attempt = 0; attempt < 100; ++attempt)
    {
      this->Path = std::filesystem::path(parent) / ("flipflop-" + std::to_string(device()));
      if (std::filesystem::create_directory(this->Path, error))
      {
        return;
      }
    }
    throw std::runtime_error(
      "The folder \"" + parent + "\" for blocks that wait cannot be written.");
  }
  OwnFolder(const OwnFolder&) = delete;
  void operator=(const OwnFolder&) = delete;
  ~OwnFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Path, ignored);
  }

  std::filesystem::path Path;
};

/// The pieces, each read twice.
class Pieces
{
public:
  Pieces(vtkIdType count, const vtkFFStreamedBlocks::PieceOf& pieceOf)
    : PieceOf(pieceOf)
    , Counts(static_cast<std::size_t>(count), -1)
  {
  }

  /// use (const double* position, std::int64_t id) for each point.
  template <class Use>
  void Each(const Use& use)
  {
    std::int64_t id = 0;
    for (std::size_t piece = 0; piece < this->Counts.size(); ++piece)
    {
      const std::vector<double> positions = this->Read(piece);
      const std::int64_t first = id;
      for (std::size_t i = 0; i < positions.size(); i += 3)
      {
        const double* const x = positions.data() + i;
        if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
        {
          Fail(piece,
            "has a coordinate or a weight that is NaN or infinite, at its point " +
              std::to_string(id - first));
        }
        use(x, id++);
      }
    }
    this->Total = id;
  }

  std::int64_t Total = 0;

private:
  [[noreturn]] static void Fail(std::size_t piece, const std::string& what)
  {
    throw std::runtime_error("Piece " + std::to_string(piece) + " of the points " + what + ".");
  }

  std::vector<double> Read(std::size_t piece)
  {
    std::vector<double> positions;
    try
    {
      positions = this->PieceOf(static_cast<vtkIdType>(piece));
    }
    catch (const std::exception& error)
    {
      Fail(piece, std::string("could not be read: ") + error.what());
    }
    const auto count = static_cast<std::int64_t>(positions.size() / 3);
    if (positions.size() % 3 != 0)
    {
      Fail(piece, "has " + std::to_string(positions.size()) + " numbers, and not three a point");
    }
    if (this->Counts[piece] >= 0 && this->Counts[piece] != count)
    {
      Fail(piece,
        "has " + std::to_string(count) + " points, and had " + std::to_string(this->Counts[piece]) +
          " when it was read first");
    }
    this->Counts[piece] = count;
    return positions;
  }

  const vtkFFStreamedBlocks::PieceOf& PieceOf;
  std::vector<std::int64_t> Counts;
};

vtkFFPointRegions::Key keyOf(const double* x)
{
  return { x[0], x[1] };
}

/// Keys of points taken by chance, the same ones each time.
vtkFFPointRegions regionsOf(Pieces& pieces, int blocks)
{
  const std::size_t size = vtkFFPointRegions::GetSampleSize(blocks);
  std::vector<vtkFFPointRegions::Key> sample;
  std::mt19937_64 generator(size);
  pieces.Each(
    [&](const double* x, std::int64_t id)
    {
      if (sample.size() < size)
      {
        sample.push_back(keyOf(x));
        return;
      }
      const auto at = generator() % static_cast<std::uint64_t>(id + 1);
      if (at < size)
      {
        sample[at] = keyOf(x);
      }
    });
  return { std::move(sample), blocks };
}

class StreamedRun
{
public:
  StreamedRun(const Settings& settings, const vtkFFStreamedBlocks::Use& use)
    : Use(use)
    , Shape(settings.Shape)
    , Chosen(settings.Options)
    , Options(settings.Options)
    , Blocks(settings.NumberOfBlocks)
    , Folder(settings.Folder)
    , Storage((this->Folder.Path / "XXXXXX").string())
    , Master(diy::mpi::communicator(), this->ThreadCount(settings), settings.BlocksInMemory,
        &Waiting::Create, &Waiting::Destroy, &this->Storage, &Waiting::Save, &Waiting::Load,
        new diy::Master::QueueSizePolicy(LargeMessage))
    , Summaries(static_cast<std::size_t>(settings.NumberOfBlocks))
  {
    this->Options.threads = this->Master.threads() > 1 ? 1 : settings.Options.threads;
    this->Options.step = nullptr;
    if (this->Chosen.progress)
    {
      this->Options.progress = [](double fraction, void* self)
      { return static_cast<StreamedRun*>(self)->MayGoOn(fraction); };
      this->Options.progressContext = this;
    }
  }

  void Deal(Pieces& pieces, const vtkFFPointRegions& regions, int blocksInMemory)
  {
    const auto count = static_cast<std::size_t>(this->Blocks);
    const std::size_t most = std::max<std::size_t>(1 << 16,
      static_cast<std::size_t>(pieces.Total) / count * static_cast<std::size_t>(blocksInMemory));
    std::vector<std::vector<Point>> dealt(count);
    std::vector<Waiting> blocks(count);
    std::size_t held = 0;
    const auto put = [&]
    {
      for (std::size_t block = 0; block < count; ++block)
      {
        if (!dealt[block].empty())
        {
          Waiting chunk{ &this->Failure, {}, {} };
          const auto* const bytes = reinterpret_cast<const char*>(dealt[block].data());
          chunk.Bytes.assign(bytes, bytes + dealt[block].size() * sizeof(Point));
          blocks[block].Chunks.push_back(this->Storage.put(&chunk, &Waiting::Save));
          this->Failure.Throw();
          dealt[block].clear();
        }
      }
      held = 0;
    };
    pieces.Each(
      [&](const double* x, std::int64_t id)
      {
        dealt[static_cast<std::size_t>(regions.Find(keyOf(x)))].push_back(
          { { x[0], x[1], x[2] }, id });
        if (++held == most)
        {
          put();
        }
      });
    put();
    for (int block = 0; block < this->Blocks; ++block)
    {
      this->Master.add(block,
        new Waiting{
          &this->Failure, {}, std::move(blocks[static_cast<std::size_t>(block)].Chunks) },
        new diy::Link);
    }
  }

  void Compute()
  {
    this->Each(
      [this](Waiting& waiting, const Proxy& proxy)
      {
        const flipflop::BlockRun run(this->Shape, this->PointsOf(waiting), this->Options);
        this->Summaries[static_cast<std::size_t>(proxy.gid())] = run.summary();
        waiting.Bytes = run.save();
      });
    this->All = flipflop::BlockSummaries(this->Shape, this->Summaries, this->Options);
    this->Summaries.clear();
    this->EachRun(
      [this](flipflop::BlockRun& run, const Proxy& proxy)
      {
        run.begin(this->All, proxy.gid());
        this->Send(run.makeQueries(), proxy);
      });
    while (this->Exchange())
    {
      this->Each(
        [this](Waiting& waiting, const Proxy& proxy)
        {
          // A reply does not change a block: its bytes stay.
          flipflop::BlockRun run(waiting.Bytes, this->Options, this->All);
          Messages messages = Received(proxy);
          for (auto& message : messages)
          {
            message.second = run.reply(message.second);
          }
          this->Send(messages, proxy);
        },
        diy::Master::SkipNoIncoming());
      this->Exchange();
      this->EachRun(
        [this](flipflop::BlockRun& run, const Proxy& proxy)
        {
          for (const auto& message : Received(proxy))
          {
            run.receive(message.first, message.second);
          }
          this->Send(run.makeQueries(), proxy);
        },
        diy::Master::SkipNoIncoming());
    }
    this->Each(
      [this](Waiting& waiting, const Proxy& proxy)
      {
        flipflop::BlockResult result =
          flipflop::BlockRun(std::exchange(waiting.Bytes, {}), this->Options, this->All).finish();
        const std::lock_guard<std::mutex> lock(this->Mutex);
        this->Use(proxy.gid(), std::move(result));
      });
  }

private:
  using Proxy = diy::Master::ProxyWithLink;
  using Messages = std::map<int, flipflop::BlockMessage>;

  static int ThreadCount(const Settings& settings)
  {
    return std::max(1, std::min(settings.Options.threads, settings.BlocksInMemory));
  }

  bool MayGoOn(double fraction)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return !this->Failure.IsThere() &&
      this->Chosen.progress(fraction, this->Chosen.progressContext);
  }

  /// @param skip which blocks stay in their files
  template <class Work>
  void Each(const Work& work, const diy::Master::Skip& skip = diy::Master::NeverSkip())
  {
    this->Master.foreach (
      [&](Waiting* waiting, const Proxy& proxy)
      {
        if (waiting && !this->Failure.IsThere()) // none if it is skipped
        {
          try
          {
            work(*waiting, proxy);
          }
          catch (...)
          {
            this->Failure.Note(std::current_exception());
          }
        }
      },
      skip);
    this->Failure.Throw();
  }

  template <class Work>
  void EachRun(const Work& work, const diy::Master::Skip& skip = diy::Master::NeverSkip())
  {
    this->Each(
      [&](Waiting& waiting, const Proxy& proxy)
      {
        flipflop::BlockRun run(waiting.Bytes, this->Options, this->All);
        std::vector<char>().swap(waiting.Bytes);
        work(run, proxy);
        waiting.Bytes = run.save();
      },
      skip);
  }

  flipflop::BlockPoints PointsOf(Waiting& waiting)
  {
    std::vector<char> bytes;
    for (const int number : waiting.Chunks)
    {
      Waiting chunk;
      this->Storage.get(number, &chunk, &Waiting::Load);
      bytes.insert(bytes.end(), chunk.Bytes.begin(), chunk.Bytes.end());
    }
    waiting.Chunks.clear();
    const auto* const points = reinterpret_cast<const Point*>(bytes.data());
    flipflop::BlockPoints result;
    const std::size_t count = bytes.size() / sizeof(Point);
    result.positions.allocate(3 * count);
    result.ids.allocate(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      std::copy_n(points[i].Position, 3, result.positions.data() + 3 * i);
      result.ids[i] = points[i].Id;
    }
    return result;
  }

  void Send(const Messages& messages, const Proxy& proxy)
  {
    for (const auto& message : messages)
    {
      const diy::BlockID to{ message.first, 0 };
      proxy.enqueue(to, hashOf(message.second));
      proxy.enqueue(to, message.second);
    }
    this->Sent += static_cast<std::int64_t>(messages.size());
  }

  static Messages Received(const Proxy& proxy)
  {
    std::vector<int> others;
    proxy.incoming(others);
    Messages messages;
    for (const int other : others)
    {
      if (proxy.incoming(other).size() > 0)
      {
        std::size_t hash = 0;
        proxy.dequeue(other, hash);
        proxy.dequeue(other, messages[other]);
        if (hashOf(messages[other]) != hash)
        {
          throw std::runtime_error("A message between blocks has changed in its file.");
        }
      }
    }
    return messages;
  }

  /// Whether any block sent a message.
  bool Exchange()
  {
    this->Master.exchange();
    return this->Sent.exchange(0) > 0;
  }

  const vtkFFStreamedBlocks::Use& Use;
  const flipflop::BlockShape Shape;
  const flipflop::Options Chosen;
  flipflop::Options Options;
  const int Blocks;
  SharedFailure Failure;
  std::mutex Mutex;
  OwnFolder Folder;
  diy::FileStorage Storage;
  diy::Master Master;
  std::vector<flipflop::BlockMessage> Summaries;
  flipflop::BlockSummaries All;
  std::atomic<std::int64_t> Sent{ 0 };
};

}

//------------------------------------------------------------------------------
void vtkFFStreamedBlocks::Run(
  const SettingsType& settings, vtkIdType numberOfPieces, const PieceOf& pieceOf, const Use& use)
{
  StreamedRun run(settings, use);
  Pieces pieces(numberOfPieces, pieceOf);
  const vtkFFPointRegions regions = regionsOf(pieces, settings.NumberOfBlocks);
  run.Deal(pieces, regions, settings.BlocksInMemory);
  run.Compute();
}
VTK_ABI_NAMESPACE_END
