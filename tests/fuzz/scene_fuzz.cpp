// scene_fuzz FOLDER SEED CASES SECONDS: spoils shipped scenes, token by token and byte by byte, and takes each through
// load_scene, build_world and a few steps. Bad input must be refused (InputError, shapes::Error) or stop the run
// (RunError); anything else ends the program, and the case stands in FOLDER/case.toml. A case that takes longer than 60
// s counts as a hang. Ends after CASES cases or SECONDS seconds, whichever comes first. The same seed gives the same
// cases.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "libdem/scene/data_files.h"
#include "libdem/world.h"
#include "shapes/polyhedron_build.h"
#include "tests/fuzz/scene_words.h"

namespace {

namespace fs = std::filesystem;
using Tokens = std::vector<std::string>;

// A few bodies are enough, and a small file in place of a large one.
void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

std::string seed_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(file), {});
  replace_all(text, "../../bench/data/spheres_1e4.csv.gz", "bodies.csv");
  for (std::size_t at = 0; (at = text.find("\ncount = ", at)) != std::string::npos;) {
    at += 9;
    const std::size_t end = text.find_first_not_of("0123456789", at);
    text.replace(at, end - at, "7");
  }
  return text;
}

Tokens tokens_of(const std::string& text) {
  Tokens out;
  const auto word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '-' || c == '+';
  };
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    if (text[i] == '#')
      end = std::min(text.find('\n', i), text.size());
    else if (text[i] == '"')
      end = std::min(text.find('"', i + 1), text.size() - 1) + 1;
    else if (word(text[i]))
      while (end < text.size() && word(text[end])) ++end;
    if (text[i] != '#') out.push_back(text.substr(i, end - i));
    i = end;
  }
  return out;
}

const std::vector<std::string> extremes{"0",
                                        "-1",
                                        "1",
                                        "2",
                                        "3",
                                        "-0.0",
                                        "0.5",
                                        "1e300",
                                        "-1e300",
                                        "1e-300",
                                        "5e-324",
                                        "nan",
                                        "inf",
                                        "-inf",
                                        "1e9",
                                        "1e-9",
                                        "9223372036854775807",
                                        "-9223372036854775808",
                                        "4294967296",
                                        "18446744073709551616",
                                        "true",
                                        "false",
                                        "\"\"",
                                        "\"auto\"",
                                        "[]",
                                        "{}",
                                        "[[0,0,0]]",
                                        "2024-01-01",
                                        "\"\\u0000\"",
                                        "\"ü\"",
                                        "[1,2,3]",
                                        "[0,0,0]",
                                        "1_000"};

struct Fuzzer {
  std::mt19937_64 random;
  std::vector<Tokens> seeds;
  Tokens words;

  std::size_t below(std::size_t n) { return n == 0 ? 0 : random() % n; }
  bool chance(std::size_t one_in) { return below(one_in) == 0; }

  std::string fresh_token(const std::string& old) {
    const bool number = !old.empty() && (std::isdigit(static_cast<unsigned char>(old[0])) || old[0] == '-');
    if (number && !chance(3)) {  // most of these are still scenes
      constexpr double factors[] = {1.5, 0.5, -1, 1e3, 1e-3, 1e8, 1e-8, 0};
      return fmt::format("{}", std::strtod(old.c_str(), nullptr) * factors[below(std::size(factors))]);
    }
    if (chance(3)) return extremes[below(extremes.size())];
    if (chance(2)) return words[below(words.size())];
    const Tokens& other = seeds[below(seeds.size())];
    return other[below(other.size())];
  }

  void change(Tokens& t) {
    if (t.empty()) return;
    const std::size_t i = below(t.size());
    switch (below(12)) {
      case 0:
        t.erase(t.begin() + static_cast<std::ptrdiff_t>(i));
        break;
      case 1:
        t.insert(t.begin() + static_cast<std::ptrdiff_t>(i), fresh_token(t[i]));
        break;
      case 2: {  // a stretch once more, somewhere else
        const std::size_t n = std::min(t.size() - i, 1 + below(20));
        const Tokens piece(t.begin() + static_cast<std::ptrdiff_t>(i), t.begin() + static_cast<std::ptrdiff_t>(i + n));
        t.insert(t.begin() + static_cast<std::ptrdiff_t>(below(t.size())), piece.begin(), piece.end());
        break;
      }
      default: {  // values, mostly numbers; not blanks
        std::size_t k = i;
        const char* wanted = chance(4) ? nullptr : "0123456789-";
        for (int tries = 0; tries < 50; ++tries, k = below(t.size()))
          if (wanted ? std::strchr(wanted, t[k][0]) != nullptr
                     : t[k].find_first_not_of(" \n=[],{}") != std::string::npos)
            break;
        t[k] = fresh_token(t[k]);
      }
    }
  }

  std::string next() {
    Tokens t = seeds[below(seeds.size())];
    for (std::size_t n = chance(2) ? 1 : 1 + below(4); n > 0; --n) change(t);
    std::string text;
    for (const std::string& token : t) text += token;
    if (chance(10) && !text.empty())
      for (std::size_t n = 1 + below(4); n > 0; --n) text[below(text.size())] = static_cast<char>(random());
    return text;
  }
};

// What a scene may ask for here; a real one may ask for more.
bool small(const dem::Scene& scene) {
  std::uint64_t bodies = scene.bodies.size();
  for (const dem::FillSpec& f : scene.fills) bodies += std::min<std::uint64_t>(f.count, 1000000);
  return bodies < 400;
}

struct Tally {
  std::size_t cases = 0, refused = 0, ran = 0, stopped = 0, large = 0;
};

void take(const std::string& path, Tally& tally) {
  ++tally.cases;
  try {
    const dem::Scene scene = dem::load_scene(path);
    if (!small(scene)) {
      ++tally.large;
      return;
    }
    dem::scene_to_toml(scene);
    dem::World world = dem::build_world(scene);
    for (int i = 0; i < 3; ++i) dem::advance(world, 1);
    dem::state_hash(world);
    dem::load_state(world, dem::save_state(world));
    ++tally.ran;
  } catch (const dem::InputError&) {
    ++tally.refused;
  } catch (const shapes::Error&) {
    ++tally.refused;
  } catch (const dem::RunError&) {
    ++tally.stopped;
  }
}

extern "C" void hang(int) {
  static const char text[] = "a case takes longer than 60 s\n";
  (void)!write(STDERR_FILENO, text, sizeof text - 1);
  std::abort();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    fmt::print(stderr, "usage: scene_fuzz FOLDER SEED CASES SECONDS\n");
    return 2;
  }
  const fs::path folder = argv[1];
  fs::create_directories(folder);
  std::ofstream(folder / "bodies.csv")
      << "x,y,z,radius\n0.01,0.01,0.001,0.001\n0.02,0.01,0.001,0.001\n0.012,0.01,0.001,0.001\n";
  for (const std::string& name : dem::shipped_scenes())  // scenes find their tables and what they include beside them
    for (const auto& file : fs::directory_iterator(fs::path(dem::path_of_scene(name)).parent_path()))
      if (file.path().extension() == ".csv" || file.path().extension() == ".toml")
        fs::copy_file(file.path(), folder / file.path().filename(), fs::copy_options::overwrite_existing);
  Fuzzer fuzzer{std::mt19937_64(std::strtoull(argv[2], nullptr, 10)), {}, {}};
  for (const std::string& name : dem::shipped_scenes())
    fuzzer.seeds.push_back(tokens_of(seed_text(dem::path_of_scene(name))));
  fuzzer.words = scene_words();
  std::signal(SIGALRM, hang);
  const std::size_t cases = std::strtoull(argv[3], nullptr, 10);
  const double seconds = std::strtod(argv[4], nullptr);
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  const std::string path = (folder / "case.toml").string();
  Tally tally;
  for (const std::string& name : dem::shipped_scenes()) {  // as they are: they must run
    std::ofstream(path, std::ios::binary) << seed_text(dem::path_of_scene(name));
    alarm(60);
    take(path, tally);
  }
  const bool sound = tally.ran == fuzzer.seeds.size();
  while (tally.cases < cases && elapsed() < seconds) {
    std::ofstream(path, std::ios::binary) << fuzzer.next();
    alarm(60);
    take(path, tally);
  }
  fmt::print("{} cases in {:.0f} s: {} refused, {} ran, {} stopped with a message, {} too large to try\n", tally.cases,
             elapsed(), tally.refused, tally.ran, tally.stopped, tally.large);
  if (!sound) fmt::print(stderr, "a shipped scene does not run\n");
  return sound && tally.refused > 0 ? 0 : 1;
}
