#include "tests/witness/peer.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

#ifndef WITNESS_PEER
#define WITNESS_PEER ""  // not built: nothing asks then
#endif

namespace witness {

namespace {

void write(FILE* to, const Body& b) {
  const auto number = [&](double x) { std::fprintf(to, " %.17g", x); };
  const char* const names[] = {"sphere", "ellipsoid", "box", "polyhedron"};
  std::fprintf(to, " %s", names[static_cast<std::size_t>(b.type)]);
  for (const double x :
       {b.size.x, b.size.y, b.size.z, b.orientation.w, b.orientation.x, b.orientation.y, b.orientation.z})
    number(x);
  if (b.type != Type::polyhedron) return;
  std::fprintf(to, " %zu", b.shape->vertices.size());
  for (const Vec3d& v : b.shape->vertices)
    for (int k = 0; k < 3; ++k) number(v[k]);
  std::fprintf(to, " %zu", b.shape->faces.size());
  for (const auto& f : b.shape->faces) {
    std::fprintf(to, " %u", f.count);
    for (std::uint32_t k = 0; k < f.count; ++k) std::fprintf(to, " %u", b.shape->face_vertices[f.first + k]);
  }
}

Answer parsed(const std::string& line) {
  Answer answer;
  if (line == "threw") {
    answer.end = Answer::End::threw;
    return answer;
  }
  const char* at = line.c_str();
  const auto number = [&] {
    char* end = nullptr;
    const double x = std::strtod(at, &end);
    at = end;
    return x;
  };
  const auto vector = [&] {
    const double x = number(), y = number();
    return Vec3d{x, y, number()};
  };
  answer.end = Answer::End::answered;
  answer.overlap = number() != 0;
  answer.gap = number();
  answer.direction = vector();
  answer.has_points = number() != 0;
  answer.point_a = vector();
  answer.point_b = vector();
  return answer;
}

// Runs the peer on the pairs from `first` on; appends what it answered, and how it ended when that was before the end.
void run(Query query, const std::vector<Pair>& pairs, std::vector<Answer>& answers) {
  FILE* const in = std::tmpfile();
  FILE* const out = std::tmpfile();
  for (std::size_t i = answers.size(); i < pairs.size(); ++i) {
    write(in, pairs[i].a);
    write(in, pairs[i].b);
    for (int k = 0; k < 3; ++k) std::fprintf(in, " %.17g", pairs[i].offset[k]);
    std::fputc('\n', in);
  }
  std::fflush(in);
  lseek(fileno(in), 0, SEEK_SET);
  const pid_t child = fork();
  if (child == 0) {
    dup2(fileno(in), STDIN_FILENO);
    dup2(fileno(out), STDOUT_FILENO);
    dup2(open("/dev/null", O_WRONLY), STDERR_FILENO);  // what it prints as it aborts
    execl(WITNESS_PEER, WITNESS_PEER, name_of(query), static_cast<char*>(nullptr));
    _exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  std::rewind(out);
  std::string line;
  for (int c; (c = std::fgetc(out)) != EOF;) {
    if (c != '\n') {
      line += static_cast<char>(c);
      continue;
    }
    answers.push_back(parsed(line));
    line.clear();
  }
  std::fclose(in);
  std::fclose(out);
  if (answers.size() == pairs.size()) return;
  Answer last;
  const bool late = WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF;
  last.end = late ? Answer::End::hung : Answer::End::aborted;
  answers.push_back(last);
}

}  // namespace

const char* name_of(Query query) {
  const char* const names[] = {"fcl", "epa", "mpr"};
  return names[static_cast<std::size_t>(query)];
}

std::vector<Answer> ask(Query query, const std::vector<Pair>& pairs) {
  std::vector<Answer> answers;
  for (int hung = 0; answers.size() < pairs.size() && hung < 8;) {
    run(query, pairs, answers);
    if (answers.back().end == Answer::End::hung) ++hung;
  }
  answers.resize(pairs.size());
  return answers;
}

}  // namespace witness
