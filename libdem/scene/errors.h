// Collects what is wrong with a scene, so that one reading reports every mistake, in the order of the file.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "libdem/scene/node.h"
#include "libdem/scene/scene.h"

namespace dem {

// "file:line:column: message", the source line and a caret below the column; without a line just "file: message".
std::string located(const Where& where, const std::string& message);

class Errors {
 public:
  // The files that positions count: the scene first.
  explicit Errors(std::vector<std::string> files) : files_(std::move(files)) {}
  // A position without a line is that of a --set override.
  void add(const Position& position, std::string message);
  bool empty() const { return found_.empty(); }
  void throw_if_any() const;
  Where where(const Position& position) const;
  // The file that holds the position; the scene itself for --set.
  const std::string& file(const Position& position) const { return files_[position.line > 0 ? position.file : 0]; }

 private:
  std::vector<std::string> files_;
  std::vector<std::pair<Position, std::string>> found_;
};

}  // namespace dem
