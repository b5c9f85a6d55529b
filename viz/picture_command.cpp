#include "viz/picture_command.h"

#include "viz/followed_picture.h"
#include "viz/virtual_screen.h"

namespace sightline::viz {

PictureCommand::PictureCommand(CLI::App& program)
    : command_(program.add_subcommand("picture", "A picture in a window: drag to move it, wheel to come closer")) {
  command_->add_option("file", file_, "The picture, in any format that OpenImageIO reads")
      ->option_text("FILE")
      ->required();
  command_->add_flag("--follow", follows_, "Shows what becomes of the file, and closes when it is gone");
}

int PictureCommand::run() const {
  if (!has_display()) throw ScreenError("no display to open a window on");
  open_picture(file_, follows_);
  return 0;
}

}  // namespace sightline::viz
