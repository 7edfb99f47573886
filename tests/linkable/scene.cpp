// A scene, run from another program.
#include "libdem/scene/scene.h"

#include <cstdio>

#include "libdem/run.h"

int main(int, char** argv) {
  dem::World world = dem::build_world(dem::load_scene(argv[1], {"run.steps=50"}));
  for (int i = 0; i < 50; ++i) dem::advance(world, 1);
  std::printf("%016llx\n", static_cast<unsigned long long>(dem::state_hash(world)));
}
