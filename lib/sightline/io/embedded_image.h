#pragma once
/// Images that come within other files.

#include <filesystem>
#include <memory>
#include <string_view>

#include "sightline/io/output_file.h"

namespace sightline {

/// An image's bytes as a file of its own among the temporary ones, where what reads images by tiles can go back to it.
/// It goes with this object, or with the program.
class EmbeddedImage {
 public:
  /// \throws FileError.
  explicit EmbeddedImage(std::string_view bytes);
  const std::filesystem::path& path() const { return file_.temporary(); }

 private:
  OutputFile file_;  ///< Never committed, see O1.
};

/// The extension of the format that bytes begin as, such as ".png"; empty for none that a model may embed.
std::string_view image_extension(std::string_view bytes);

/// \throws FileError.
std::shared_ptr<const EmbeddedImage> keep_image(std::string_view bytes);

}  // namespace sightline
