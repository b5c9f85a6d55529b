#include "viz/render_mpi/ranks.h"

#include <mpi.h>
#include <signal.h>

#include <chrono>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <type_traits>

namespace sightline::render_mpi {
namespace {

/// MPI's own waiting would keep a core busy.
void rest() { std::this_thread::sleep_for(std::chrono::microseconds(100)); }

template <class T>
void put(std::string& bytes, const T* values, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<T>);
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

template <class T>
void take(std::string_view& bytes, T* values, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (bytes.size() < count * sizeof(T)) throw std::runtime_error("a message of another rank is too short");
  if (count > 0) std::memcpy(values, bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
}

}  // namespace

std::string bytes_of(const TileTask& task) {
  std::string bytes;
  const std::uint64_t open = task.open.size();
  put(bytes, &task.tile.rect, 1);
  put(bytes, &task.end_of_pass, 1);
  put(bytes, &task.asks, 1);
  put(bytes, &open, 1);
  put(bytes, task.open.data(), task.open.size());
  put(bytes, task.tile.sums.data(), task.tile.sums.size());
  put(bytes, task.tile.facts.data(), task.tile.facts.size());
  return bytes;
}

TileTask task_of(std::string_view bytes) {
  constexpr int largest_side = 1 << 14;
  TileRect rect;
  take(bytes, &rect, 1);
  const auto is_side = [](int side) { return side >= 0 && side <= largest_side; };
  if (!is_side(rect.width) || !is_side(rect.height) || rect.pixels() > bytes.size()) {
    throw std::runtime_error("a message of another rank has no tile");
  }
  TileTask task{TileBuffer(rect), {}, 0, FactsAsked::none};
  std::uint64_t open = 0;
  take(bytes, &task.end_of_pass, 1);
  take(bytes, &task.asks, 1);
  take(bytes, &open, 1);
  if (open > rect.pixels()) throw std::runtime_error("a message of another rank has too many pixels");
  task.open.resize(open);
  take(bytes, task.open.data(), task.open.size());
  for (const std::uint32_t place : task.open) {
    if (place >= rect.pixels()) throw std::runtime_error("a message of another rank has pixels outside its tile");
  }
  take(bytes, task.tile.sums.data(), task.tile.sums.size());
  take(bytes, task.tile.facts.data(), task.tile.facts.size());
  return task;
}

// ---- Messages

Ranks::Ranks(int& argc, char**& argv) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);  // other threads render, show and write
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  is_busy_.resize(static_cast<std::size_t>(size_));
}

Ranks::~Ranks() {
  if (is_first()) end_all();
  MPI_Finalize();
}

void Ranks::send(int rank, Tag tag, std::string_view bytes) {
  MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, rank, tag, MPI_COMM_WORLD);
}

/// One that has come, of those of one rank in the order in which they were sent.
Ranks::Message Ranks::receive() {
  int is_there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, &status);
  if (!is_there) return {};
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  Message message{status.MPI_SOURCE, static_cast<Tag>(status.MPI_TAG),
                  std::string(static_cast<std::size_t>(size), '\0')};
  MPI_Recv(message.bytes.data(), size, MPI_BYTE, message.rank, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return message;
}

// ---- Rank 0

bool Ranks::expose(Film& film, const PictureSource& source, const ExposureOptions& options,
                   const std::atomic<bool>& stops) {
  if (size_ == 1) return sightline::expose(film, source, options, stops);
  hear_ready(source.fingerprint(), stops);
  while (!stops) {
    const std::vector<TileRect> tiles = film.open_tiles(options.tile_side);
    if (!tiles.empty()) {
      hand_out(film, tiles, stops);
    } else if (!film.begin_pass()) {
      return true;
    }
  }
  return false;
}

void Ranks::hear_ready(std::uint64_t fingerprint, const std::atomic<bool>& stops) {
  while (ready_ < size_ - 1 && !stops) {
    const Message message = receive();
    if (message.rank < 0) {
      rest();
      continue;
    }
    if (message.tag == failure) {
      throw std::runtime_error("rank " + std::to_string(message.rank) + ": " + message.bytes);
    }
    std::uint64_t its = 0;
    std::string_view bytes = message.bytes;
    take(bytes, &its, 1);
    if (its != fingerprint) {
      throw std::runtime_error("rank " + std::to_string(message.rank) +
                               " would render another picture: do all ranks see the same files?");
    }
    ++ready_;
  }
}

void Ranks::hand_out(Film& film, const std::vector<TileRect>& tiles, const std::atomic<bool>& stops) {
  std::size_t next = 0, done = 0;
  while (done < tiles.size() && !stops) {
    for (int rank = 1; rank < size_ && next < tiles.size(); ++rank) {
      if (is_busy_[static_cast<std::size_t>(rank)]) continue;
      send(rank, task, bytes_of(film.task(tiles[next++])));  // M2
      is_busy_[static_cast<std::size_t>(rank)] = true;
    }
    const Message message = receive();
    if (message.rank < 0) {
      rest();
      continue;
    }
    is_busy_[static_cast<std::size_t>(message.rank)] = false;
    if (message.tag == failure) {
      throw std::runtime_error("rank " + std::to_string(message.rank) + ": " + message.bytes);
    }
    std::string_view bytes = message.bytes;
    RenderCounters counters;
    take(bytes, &counters, 1);
    film.put(task_of(bytes), counters);
    ++done;
  }
}

/// What they still had to say is heard, and left aside.
void Ranks::end_all() {
  for (int rank = 1; rank < size_; ++rank) send(rank, end, {});
  for (int left = size_ - 1; left > 0;) {
    const Message message = receive();
    if (message.rank < 0) rest();
    if (message.rank >= 0 && message.tag == farewell) --left;
  }
}

// ---- The others

void Ranks::work(const std::function<std::unique_ptr<PictureSource>()>& make_source) {
  // Rank 0 is signalled as well, and ends all in order. Where it cannot, mpirun kills.
  for (const int number : {SIGINT, SIGTERM}) signal(number, SIG_IGN);
  std::unique_ptr<PictureSource> source;
  try {
    source = make_source();
    const std::uint64_t fingerprint = source->fingerprint();
    std::string bytes;
    put(bytes, &fingerprint, 1);
    send(0, ready, bytes);
  } catch (const std::exception& error) {
    send(0, failure, error.what());
  }
  while (true) {
    const Message message = receive();
    if (message.rank < 0) {
      rest();
      continue;
    }
    if (message.tag == end) break;
    try {
      TileTask tile = task_of(message.bytes);
      RenderCounters counters;
      expose_tile(tile, *source, counters);
      std::string bytes;
      put(bytes, &counters, 1);
      send(0, result, bytes + bytes_of(tile));
    } catch (const std::exception& error) {
      send(0, failure, error.what());
    }
  }
  send(0, farewell, {});
}

}  // namespace sightline::render_mpi
