// HDF5 record and checkpoints: what is written comes back; damage and truncation are met.
#include <gtest/gtest.h>

#include <fstream>

#include "libdem/io/io.h"
#include "tests/libdem/io_world.h"

namespace {

using dem::World;
using dem::io_test::Folder;

void expect_same_particles(const World& a, const World& b) {
  const auto &p = a.particles, &q = b.particles;
  ASSERT_EQ(p.count(), q.count());
  EXPECT_EQ(p.id, q.id);
  EXPECT_EQ(p.shape, q.shape);
  EXPECT_EQ(p.material, q.material);
  EXPECT_EQ(p.species, q.species);
  for (std::size_t i = 0; i < p.count(); ++i) {
    EXPECT_EQ(p.size[i], q.size[i]);
    EXPECT_EQ(p.motion[i].position, q.motion[i].position);
    EXPECT_EQ(p.motion[i].velocity, q.motion[i].velocity);
    EXPECT_EQ(p.motion[i].spin, q.motion[i].spin);
    EXPECT_EQ(p.rotation[i], q.rotation[i]);
    EXPECT_EQ(p.orientation[i].w, q.orientation[i].w);
    EXPECT_EQ(p.orientation[i].z, q.orientation[i].z);
    EXPECT_DOUBLE_EQ(p.mass[i], q.mass[i]);
    EXPECT_DOUBLE_EQ(p.motion[i].bounding_radius, q.motion[i].bounding_radius);
    EXPECT_DOUBLE_EQ(p.motion[i].equivalent_radius, q.motion[i].equivalent_radius);
  }
}

TEST(IoRecord, WrittenAppendedTruncatedRead) {
  const Folder folder("record");
  const std::string path = folder / "record.h5";
  World first = dem::io_test::small_world();
  first.step = 0;
  dem::io::Record(path, first, false).write(first);
  World second = first;  // later: one body is gone, another has moved, the gate is open
  second.step = 90;
  second.particles = {};
  second.contacts = {};
  dem::io_test::add_body(second, 1, 1, 0.7, {1, 2, 1.0 / 3.0}, {0.1, 0.9, 0.3, 0.2}, {4, 5, 6}, {7, 8, 9});
  second.walls[1].present = false;
  dem::io::Record(path, second, true).write(second);
  second.step = 1000;
  dem::io::Record(path, second, true).write(second);
  EXPECT_EQ(dem::io::frame_count(path), 3);

  World read = dem::io_test::small_world();
  dem::io::load_frame(path, read, 1);
  expect_same_particles(second, read);
  EXPECT_EQ(read.step, 90u);
  EXPECT_FALSE(read.walls[1].present);
  EXPECT_EQ(read.contacts.count(), 0u);
  dem::io::load_frame(path, read, 0);
  expect_same_particles(first, read);
  EXPECT_TRUE(read.walls[1].present);
  ASSERT_EQ(read.contacts.count(), 2u);
  EXPECT_EQ(read.contacts.key, first.contacts.key);
  EXPECT_EQ(read.contacts.slot[0].force, first.contacts.slot[0].force);
  EXPECT_EQ(read.contacts.history[1].force_t, first.contacts.history[1].force_t);

  dem::io::Record(path, second, true).truncate_after(90);
  EXPECT_EQ(dem::io::frame_count(path), 2);
  dem::io::load_frame(path, read, 1);
  EXPECT_EQ(read.step, 90u);
  EXPECT_THROW(dem::io::load_frame(path, read, 2), dem::RunError);
  EXPECT_THROW(dem::io::load_frame(path, read, -1), dem::RunError);
}

TEST(IoRecord, NotARecord) {
  const Folder folder("record_bad");
  std::ofstream(folder / "record.h5") << "no HDF5 file";
  World world = dem::io_test::small_world();
  EXPECT_THROW(dem::io::frame_count(folder / "record.h5"), dem::RunError);
  EXPECT_THROW(dem::io::Record(folder / "record.h5", world, true), dem::RunError);
}

std::size_t file_count(const std::string& folder) {
  const std::filesystem::directory_iterator files(folder);
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

// In pieces of many sizes, as it comes.
dem::io::Pieces in_pieces(const std::vector<std::uint8_t>& state) {
  return [state](const dem::Sink& sink) {
    for (std::size_t first = 0, size = 0; first < state.size(); first += size, size = (size + 1) % 23)
      sink(std::span(state).subspan(first, std::min(size, state.size() - first)));
  };
}

std::vector<std::uint8_t> state_of(std::uint8_t seed) {
  std::vector<std::uint8_t> state(1003);
  for (std::size_t i = 0; i < state.size(); ++i) state[i] = static_cast<std::uint8_t>(i * 7 + seed);
  return state;
}

TEST(IoCheckpoint, KeepsTwoAndReadsTheNewest) {
  const Folder folder("checkpoint");
  EXPECT_FALSE(dem::io::read_last_checkpoint(folder.path()));
  for (const std::uint8_t step : {std::uint8_t{10}, std::uint8_t{20}, std::uint8_t{30}})
    dem::io::write_checkpoint(folder.path(), step, in_pieces(state_of(step)));
  EXPECT_EQ(file_count(folder.path()), 2u);
  const auto last = dem::io::read_last_checkpoint(folder.path());
  ASSERT_TRUE(last);
  EXPECT_EQ(last->step, 30u);
  EXPECT_EQ(last->state, state_of(30));
}

TEST(IoCheckpoint, DamagedNewestFallsBackToTheOlder) {
  const Folder folder("checkpoint_damaged");
  const std::string newest = folder / "checkpoint-000000000020.bin";
  const auto expect_older = [&] {
    const auto last = dem::io::read_last_checkpoint(folder.path());
    ASSERT_TRUE(last);
    EXPECT_EQ(last->step, 10u);
    EXPECT_EQ(last->state, state_of(10));
  };
  dem::io::write_checkpoint(folder.path(), 10, in_pieces(state_of(10)));
  for (const std::streamoff place : {0, 8, 16, 24, 32, 40, 500, 1042}) {  // every word of the header, and the payload
    dem::io::write_checkpoint(folder.path(), 20, in_pieces(state_of(20)));
    ASSERT_EQ(dem::io::read_last_checkpoint(folder.path())->step, 20u);
    std::fstream file(newest, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(place);
    const char byte = static_cast<char>(file.get() ^ 1);
    file.seekp(place);
    file.put(byte);
    file.close();
    expect_older();
  }
  for (const std::uintmax_t length : {0, 20, 40, 1042}) {
    dem::io::write_checkpoint(folder.path(), 20, in_pieces(state_of(20)));
    std::filesystem::resize_file(newest, length);
    expect_older();
  }
  // A run that goes on from the older one leaves the damaged one behind and never deletes what it started from.
  dem::io::write_checkpoint(folder.path(), 15, in_pieces(state_of(15)));
  EXPECT_FALSE(std::filesystem::exists(newest));
  EXPECT_TRUE(std::filesystem::exists(folder / "checkpoint-000000000010.bin"));
  EXPECT_EQ(dem::io::read_last_checkpoint(folder.path())->step, 15u);
}

}  // namespace
