#pragma once
/// What is asked of a student's program, and what is said when it fails.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "labs/check/subject.h"
#include "viz/drawing/drawing.h"

namespace sightline::labs {

/// An input as whole numbers, which a check makes triangles, rays or lists of. Numbers nearer to zero, and fewer items,
/// are simpler: shrinking goes there, and what is left can be read, typed, and sent to a teacher.
struct Case {
  std::vector<int> head;                ///< As many as the recipe says.
  std::vector<std::vector<int>> items;  ///< Such as triangles.

  /// "1,0,-2/0,1/3,4": the head, then the items.
  std::string text() const;
};

/// What cases of a check look like.
struct Recipe {
  int head = 0;  ///< Numbers.
  int item = 0;  ///< Numbers of each item; 0 where there are no items.
  int most_items = 0;
  int range = 0;  ///< All numbers lie in [-range, range].

  /// \throws std::invalid_argument where the text is no case of this recipe.
  Case parse(const std::string& text) const;
};

/// What came out, where it is not what it should be.
struct Trouble {
  std::string expected, got;
};

/// One thing that has to hold.
struct Check {
  std::string name;                ///< "equal-distance": what it is about.
  std::string section;             ///< Of the handout: "3. Tie rules".
  std::string why;                 ///< What goes wrong in pictures or programs where it does not hold.
  std::vector<std::string> hints;  ///< One more with each time that a hint is asked for.
  Recipe recipe;
  int count = 100;         ///< Cases that are tried; a recipe without numbers has but one.
  bool is_budget = false;  ///< Of work, not of results.

  /// Nothing where it holds. What the subject throws is trouble too.
  std::function<std::optional<Trouble>(const Case&, Subject&)> ask;
  /// The input in words.
  std::function<std::string(const Case&)> describe;
  /// Optional: the input, the right and the wrong result. Only asked for after trouble; what the subject throws while
  /// it is asked leaves the drawing out.
  std::function<Drawing(const Case&, Subject&)> draw;
};

/// A part of the course.
struct Lab {
  std::string number, name;        ///< "00", "first-picture": its folder is both.
  std::string title;               ///< "First picture".
  std::vector<std::string> files;  ///< What the student writes.
  std::vector<Check> checks;
  /// What appears when it works. \throws SubjectTrouble
  std::function<Drawing(Subject&)> picture;
  std::string structure;  ///< The class that satisfies the contract of accelerators, where one is written.

  std::string folder() const { return number + "-" + name; }
};

/// How a check went.
struct Outcome {
  enum class State { passed, failed, hole };
  State state = State::passed;
  const Check* check = nullptr;
  int cases = 0;  ///< Tried, before any shrinking.
  // Of a failure, at its simplest:
  Case at;
  Trouble trouble;
  std::string printed;  ///< By the program.

  /// What `replay --case` takes.
  std::string id() const { return check->name + ":" + at.text(); }
};

/// Tries cases drawn with this seed; what fails is shrunk as far as it goes.
Outcome run(const Check& check, Subject& subject, std::uint64_t seed);
/// The same for one case.
Outcome run_case(const Check& check, Subject& subject, const Case& at);
/// What a check draws of a case, where it does and the subject answers.
std::optional<Drawing> draw(const Check& check, Subject& subject, const Case& at);

}  // namespace sightline::labs
