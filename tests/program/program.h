// Running the dem program as a user does: as a process of its own, in a folder of its own.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>
#include <vector>

namespace program {

struct Outcome {
  int exit_code = -1;  // 128 + signal when a signal ended it
  std::string out, err;
};

// A fresh folder, removed at the end.
class Folder {
 public:
  Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder();
  std::string path(std::string_view name) const { return path_ + "/" + std::string(name); }
  const std::string& path() const { return path_; }
  std::string write(std::string_view name, std::string_view text) const;  // returns the path
  std::vector<std::string> files() const;                                 // relative, sorted

 private:
  std::string path_;
};

// A running dem; its output goes to files of `folder`.
class Process {
 public:
  Process(const std::vector<std::string>& arguments, const Folder& folder);
  void signal(int number) const;
  Outcome wait();

 private:
  const Folder& folder_;
  pid_t pid_;
};

Outcome dem(const std::vector<std::string>& arguments);
std::string read(const std::string& path);
// `text` with the first `from` replaced; fails the test when it is not there.
std::string replaced(std::string text, std::string_view from, std::string_view to);

// Three bodies above a floor, 200 steps: runs in a moment.
extern const char* const small_scene;

}  // namespace program
