#pragma once

#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <filesystem>
#include <memory>

namespace sightline::viz {

/// A picture of a file in a window, as large as it fits, which follows the file.
class FollowedPicture {
 public:
  /// Refers to the window. \throws FileError
  FollowedPicture(const std::filesystem::path& file, vtkRenderWindow& window);
  ~FollowedPicture();
  FollowedPicture(const FollowedPicture&) = delete;
  FollowedPicture& operator=(const FollowedPicture&) = delete;

  /// Shows what the file is, where it changed; what cannot be read leaves the picture as it is. False where there is no
  /// file any more.
  bool look();

 private:
  struct Shown;
  std::unique_ptr<Shown> shown_;
};

/// Until the window is closed, or `follows` and the file is gone. \throws FileError
void open_picture(const std::filesystem::path& file, bool follows);

}  // namespace sightline::viz
