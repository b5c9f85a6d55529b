#include "viz/graph/graph_command.h"

#include <cmath>
#include <iostream>
#include <optional>

#include "sightline/io/output_file.h"
#include "sightline/io/progress.h"
#include "viz/graph/graph_scene.h"
#include "viz/graph/graph_table.h"
#include "viz/graph/graph_window.h"
#include "viz/virtual_screen.h"

namespace sightline::viz {
namespace {

constexpr const char* about = R"(A scene graph: its tree beside the scene, bounds that follow, events that bubble up.

A scene is a tree of nodes, each placed within its parent. Every node has a bound that holds its own geometry and all
below it. When a node is moved, an event bubbles up from it to the root and marks the bounds on its way as stale: that
is all a change costs. What is below moves along and is not told. Bounds are computed again when somebody asks for
them, each once, children first.

The table goes to stdout: nodes, their depth, what the event did to them, and the volume of their bound before and
after. Bounds in the picture have the color of their depth; those that coincide are drawn a little apart.

Examples
  sightline-view graph --scene levels:4
      the course's renderLevel; opens a window where there is a display
  sightline-view graph --scene levels:4 --select left/left --drag=-0.9,0.7,0 --out bubble.png
      before, the event's way up step by step, and after
  sightline-view graph --scene rocket --time 0:5.4 --frames 7 --out flight.png
      the rocket's motion, which knows nothing of its shape
  sightline-view graph --scene jacks:2 --bounds cylinder --out jacks.png

In the window, H shows the keys.)";

BoundKind parse_kind(const std::string& text) {
  std::string names;
  for (const BoundKind kind : bound_kinds) {
    if (name_of(kind) == text) return kind;
    names += (names.empty() ? "" : ", ") + std::string(name_of(kind));
  }
  refuse("--bounds", text, "one of " + names);
}

constexpr double farthest = 1e9;  // so that float still tells the scene's parts apart from nothing

Vec3d parse_way(const std::string& option, const std::string& text) {
  const auto v = finite_numbers(text, 3, ',');
  if (!v || max_norm(Vec3d((*v)[0], (*v)[1], (*v)[2])) > farthest)
    refuse(option, text, "X,Y,Z, three numbers from -1e9 to 1e9, in units of the world; as in 1,0.5,0");
  return {(*v)[0], (*v)[1], (*v)[2]};
}

struct Move {
  std::string node;
  Vec3d by;
};

/// "/top/left=0.5,0,0"
Move parse_move(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos) refuse("--moved", text, "NODE=X,Y,Z; as in /top/left=1,0.5,0");
  return {text.substr(0, equals), parse_way("--moved " + text.substr(0, equals), text.substr(equals + 1))};
}

struct Times {
  double first, last;
};

Times parse_times(const std::string& text) {
  const auto v = finite_numbers(text, 2, ':');
  if (!v || std::abs((*v)[0]) > 1e6 || std::abs((*v)[1]) > 1e6 || (*v)[0] > (*v)[1])
    refuse("--time", text, "T0:T1, two numbers of seconds from -1e6 to 1e6, T0 not above T1; as in 0:2.5");
  return {(*v)[0], (*v)[1]};
}

}  // namespace

GraphCommand::GraphCommand(CLI::App& program, const std::string& data_folder)
    : command_(program.add_subcommand("graph", about)), data_(data_folder), camera_(*command_, 16) {
  command_->fallthrough();
  command_->add_option("--scene", scene_, "A scene of list, with or without :SIZE, rocket, or a file; default levels:4")
      ->option_text("SCENE");
  command_->add_option("--bounds", bounds_, "What holds things: box, sphere or cylinder; default box")
      ->option_text("KIND");
  command_
      ->add_option("--level", level_, "Depths whose bounds are drawn, the root's is 0; default: as many as read well")
      ->option_text("MIN:MAX");
  command_->add_flag("--bounds-only", has_bounds_only_, "No things");
  command_
      ->add_option("--select", selected_,
                   "A node to stand out: a path (/top/left), the end of one (left/sphere), a name or #NUMBER")
      ->option_text("NODE");
  auto* drag = command_->add_option("--drag", drag_, "Move it by so much in the world, and show what follows")
                   ->option_text("X,Y,Z");
  command_->add_option("--time", time_, "The scene's motion instead, from T0 to T1 in seconds")
      ->option_text("T0:T1")
      ->excludes(drag);
  command_
      ->add_option("--frames", frames_,
                   "At most so many pictures, of a motion to 24, of a drag to 12; default 6, or as many steps\nas a "
                   "drag has, to 8")
      ->check(CLI::Range(2, most_frames))
      ->option_text("N");
  command_->add_option("--size", size_, "Of the picture or window in pixels; default 1600x1000")
      ->option_text("WIDTHxHEIGHT");
  command_
      ->add_option("--moved", moved_,
                   "A node that has been moved by so much in the world before all else; may be repeated")
      ->option_text("NODE=X,Y,Z")
      ->expected(1)
      ->take_all();
  command_->add_option("--out", out_, "A .png file instead of a window")->option_text("FILE");
}

int GraphCommand::run(WindowFrame* frame) const {
  const bool has_drag = command_->count("--drag") > 0, has_time = command_->count("--time") > 0;
  const PictureSize size = parse_size_of<GraphLayout>(size_);
  GraphLook look;
  look.kind = parse_kind(bounds_);
  camera_.check();
  look.azimuth = camera_.azimuth(), look.elevation = camera_.elevation(), look.zoom = camera_.zoom();
  look.has_things = !has_bounds_only_;
  std::optional<DepthRange> levels;
  if (command_->count("--level")) levels = parse_depth(level_, "--level");
  const Vec3d way = has_drag ? parse_way("--drag", drag_) : Vec3d(0);
  std::vector<Move> moves;
  for (const std::string& text : moved_) moves.push_back(parse_move(text));
  const Times times = has_time ? parse_times(time_) : Times{0, 0};
  if (has_drag && !command_->count("--select")) refuse("--drag", drag_, "--select NODE beside it, the node to move");
  if (command_->count("--frames") && !has_drag && !has_time) {
    refuse("--frames", std::to_string(frames_), "--drag or --time beside it");
  }
  if (has_drag && frames_ > most_drag_frames) {
    refuse("--frames", std::to_string(frames_), "2 to " + std::to_string(most_drag_frames) + " beside --drag");
  }
  const bool has_picture = command_->count("--out") > 0;
  if (has_picture) {
    if (out_.empty() || extension_of(out_) != ".png") refuse("--out", out_, "a name that ends in .png");
    OutputFile check(out_);  // says now whether it can be written
  }

  Progress progress;
  progress.say("reading " + scene_);
  struct Held {
    PlayedScene played;
    LiveScene scene;
    explicit Held(PlayedScene read) : played(std::move(read)), scene(std::move(played.scene)) {}
  };
  const auto held = std::make_shared<Held>(load_played_scene(scene_, data_));
  PlayedScene& played = held->played;
  LiveScene& scene = held->scene;
  if (has_time && !played.controller) {
    refuse("--time", time_,
           "a scene that moves, which " + scene_ + " does not: levels, rocket or a file with animations");
  }
  if (command_->count("--select")) look.selected = node_by_name(scene.scene().graph, selected_);
  progress.say("bounding " + scene_);
  std::map<NodeId, Vec3d> moved;
  for (const Move& move : moves) {
    const NodeId node = node_by_name(scene.scene().graph, move.node);
    drag(scene, node, move.by, look.kind);
    moved.try_emplace(node, Vec3d(0)).first->second += move.by;
  }
  const DrawnScene drawn(scene.scene());
  look.deepest = readable_depth(drawn.shape, *snapshot_of(scene, look.kind), look.kind);
  if (levels) {
    look.shallowest = static_cast<std::uint32_t>(levels->shallowest);
    look.deepest = static_cast<std::uint32_t>(std::min<int>(*levels->deepest, static_cast<int>(drawn.shape.deepest)));
    if (look.shallowest > drawn.shape.deepest) {
      refuse("--level", level_,
             "depths from 0 to " + std::to_string(drawn.shape.deepest) + ", which " + scene_ + " has");
    }
  }

  GraphPicture picture{drawn, {}, look, true, scene_, summary(drawn, look), "", size.width, size.height};
  std::optional<PictureScreen> screen;
  if (has_picture) screen.emplace();
  progress.clear();
  if (has_drag) {
    const Change change = drag(scene, look.selected, way, look.kind);
    picture.frames = frames_of(change, drawn.graph, frames_ > 0 ? frames_ : 8);
    picture.has_one_tree = false;
    picture.verdict = verdict_of(change, drawn.graph);
    std::cout << change_table(drawn.graph, drawn.shape, change, false);
  } else if (has_time) {
    picture.frames = frames_of(scene, *played.controller, times.first, times.last,
                               frames_ > 0 ? frames_ : (times.first == times.last ? 1 : 6), look.kind);
    std::cout << motion_table(drawn.graph, picture.frames, look.selected);
  } else {
    picture.frames = {still_frame(scene, look.kind)};
    std::cout << still_table(drawn.graph, drawn.shape, *picture.frames.front().places);
  }
  std::cout << std::flush;
  picture.aspect = aspect_of(drawn, picture.frames, look);
  if (has_picture) {
    progress.say("drawing " + out_);
    picture.write_png(out_);
    progress.clear();
  } else if (has_display()) {
    return open_window<GraphWindow>(frame, held, scene, played.controller.get(), played.duration, scene_, look,
                                    size.width, size.height, std::cout, moved);
  } else {
    std::cerr << "sightline-view: no display to open a window on; --out FILE.png writes the picture\n";
  }
  return 0;
}

}  // namespace sightline::viz
