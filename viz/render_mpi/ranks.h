#pragma once
/// Rendering by the ranks of an MPI run: rank 0 owns the film and all files, and hands out tiles on demand; the others
/// render one tile at a time, on one thread.
///   M1  A tile travels with its sums, and comes back with what its own samples added to them: the film is the same as
///       that of one process, bit for bit.
///   M2  A rank gets a task only while it waits for one, so that no two wait for each other to take a long message.

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sightline/render/exposure.h"

namespace sightline::render_mpi {

/// A task as bytes, and back. All ranks run one program.
std::string bytes_of(const TileTask& task);
/// \throws std::runtime_error where the bytes are not those of a task.
TileTask task_of(std::string_view bytes);

class Ranks {
 public:
  /// Begins MPI.
  Ranks(int& argc, char**& argv);
  /// Ends MPI once every rank does; rank 0 tells the others to.
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  bool is_first() const { return rank_ == 0; }

  /// Of rank 0: as sightline::expose(). \throws std::runtime_error where a rank fails or has another picture in mind.
  bool expose(Film& film, const PictureSource& source, const ExposureOptions& options, const std::atomic<bool>& stops);

  /// Of the others: renders what it is told to until it is told to end. What goes wrong is told to rank 0.
  void work(const std::function<std::unique_ptr<PictureSource>()>& make_source);

 private:
  /// `result` also holds, before the task, what was counted.
  enum Tag : int { ready, task, result, failure, end, farewell };
  struct Message {
    int rank = -1;  ///< -1: none.
    Tag tag = end;
    std::string bytes;
  };

  static void send(int rank, Tag tag, std::string_view bytes);
  static Message receive();
  void hear_ready(std::uint64_t fingerprint, const std::atomic<bool>& stops);
  void hand_out(Film& film, const std::vector<TileRect>& tiles, const std::atomic<bool>& stops);
  void end_all();

  int rank_ = 0, size_ = 1;
  int ready_ = 0;              ///< Other ranks that have a source.
  std::vector<bool> is_busy_;  ///< Ranks that have a task.
};

}  // namespace sightline::render_mpi
