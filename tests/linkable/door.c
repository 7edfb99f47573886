/* Everything of the C door; prints in hexadecimal what same.cpp prints by way of C++. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "libcontact/bindings/c/contact.h"

#define CHECK(call)                                                 \
  do {                                                              \
    const int error = (call);                                       \
    if (error != CONTACT_OK) {                                      \
      printf("line %d: %s\n", __LINE__, contact_error_text(error)); \
      return 1;                                                     \
    }                                                               \
  } while (0)
#define EXPECT(condition)                                    \
  do {                                                       \
    if (!(condition)) {                                      \
      printf("line %d: not so: %s\n", __LINE__, #condition); \
      return 1;                                              \
    }                                                        \
  } while (0)

static void put(const char* name, const double* v, int n) {
  int i;
  printf("%s", name);
  for (i = 0; i < n; ++i) printf(" %a", v[i]);
  printf("\n");
}

int main(void) {
  const double corners[24] = {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1, -1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1};
  const double flat[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const double outline[8] = {0, 0, 2, 0, 2, 1, 0, 1};
  const uint32_t triangle[3] = {0, 1, 2};
  const double c = 0.96, s = 0.28; /* a turn about z */
  contact_shape *cube = NULL, *none = NULL, *floor = NULL, *tile = NULL;
  char message[20];
  uint32_t sphere, ellipsoid, polyhedron, mesh, polygon, plane, law;
  contact_body a[6], b[6];
  contact_cache cache[6];
  contact_answer answer[6];
  double offset[18];
  contact_query_options options = {sizeof(contact_query_options), 1, 1, NULL, 0};
  contact_material soft = {sizeof(contact_material), 5e6, 0.25, 0.5, 0.4, 0, 0};
  contact_pair pair;
  contact_motion motion[2];
  contact_history history[2];
  contact_load load[2];
  int i, round, step;

  EXPECT(contact_abi_version() == CONTACT_ABI_VERSION);
  CHECK(contact_kind("sphere", &sphere));
  CHECK(contact_kind("ellipsoid", &ellipsoid));
  CHECK(contact_kind("polyhedron", &polyhedron));
  CHECK(contact_kind("mesh", &mesh));
  CHECK(contact_kind("polygon", &polygon));
  CHECK(contact_kind("plane", &plane));
  EXPECT(contact_kind("teapot", &mesh) == CONTACT_UNKNOWN_NAME);
  EXPECT(contact_law("magic", &law) == CONTACT_UNKNOWN_NAME);
  CHECK(contact_shape_polyhedron(corners, 8, 0, &cube, NULL, 0));
  EXPECT(contact_shape_polyhedron(flat, 3, 0, &none, message, sizeof message) == CONTACT_BAD_SHAPE && none == NULL);
  EXPECT(strlen(message) > 0 && strlen(message) < sizeof message);
  CHECK(contact_shape_mesh(flat, 3, triangle, 1, &floor, NULL, 0));
  CHECK(contact_shape_polygon(outline, 4, &tile, NULL, 0));

  memset(a, 0, sizeof a);
  memset(b, 0, sizeof b);
  memset(cache, 0, sizeof cache);
  for (i = 0; i < 6; ++i) {
    double* r[2];
    int k;
    r[0] = a[i].rotation;
    r[1] = b[i].rotation;
    for (k = 0; k < 2; ++k) r[k][0] = r[k][4] = r[k][8] = 1;
    offset[3 * i] = 1.9 + 0.05 * i;
    offset[3 * i + 1] = 0.1;
    offset[3 * i + 2] = 0.05 * i;
  }
  a[0].kind = b[0].kind = sphere; /* 0: two balls that overlap */
  a[0].size[0] = b[0].size[0] = 1;
  for (i = 1; i < 3; ++i) { /* 1, 2: boxes with ellipsoids, against kind order, the second one turned */
    a[i].kind = polyhedron;
    a[i].shape = cube;
    a[i].size[0] = 1;
    b[i].kind = ellipsoid;
    b[i].size[0] = 1.2;
    b[i].size[1] = 0.7;
    b[i].size[2] = 0.9;
  }
  b[2].rotation[0] = b[2].rotation[4] = c;
  b[2].rotation[1] = -s;
  b[2].rotation[3] = s;
  for (i = 3; i < 5; ++i) { /* 3: two boxes that overlap; 4: two that are apart */
    a[i].kind = b[i].kind = polyhedron;
    a[i].shape = b[i].shape = cube;
    a[i].size[0] = b[i].size[0] = 1;
  }
  offset[3 * 3] = 1.95;
  offset[3 * 4] = 2.5;
  a[5].kind = sphere; /* 5: dimensions that never meet */
  a[5].size[0] = 1;
  b[5].kind = polygon;
  b[5].shape = tile;
  b[5].size[0] = 1;

  for (round = 0; round < 2; ++round) { /* the second time with what the caches know */
    CHECK(contact_query(6, a, b, offset, &options, cache, answer));
    for (i = 0; i < 5; ++i) {
      printf("%d %d\n", answer[i].status, answer[i].certified);
      if (round == 0 || answer[i].status != CONTACT_SEPARATED) put("gap", &answer[i].gap, 1); /* else of the proof */
      put("normal", answer[i].normal, 3);
      put("centre", answer[i].patch_centre, 3);
      put("spread", answer[i].patch_spread, 6);
    }
    EXPECT(answer[5].status == CONTACT_REFUSED);
  }
  options.method = "sat";
  CHECK(contact_query(1, a + 3, b + 3, offset + 9, &options, NULL, answer));
  put("sat", &answer[0].gap, 1);
  options.method = "guess";
  EXPECT(contact_query(1, a, b, offset, &options, NULL, answer) == CONTACT_UNKNOWN_NAME);
  options.method = NULL;
  options.size = 3;
  EXPECT(contact_query(1, a, b, offset, &options, NULL, answer) == CONTACT_BAD_SIZE);
  EXPECT(contact_query(1, a, NULL, offset, NULL, NULL, answer) == CONTACT_NULL_POINTER);
  a[3].shape = floor;
  EXPECT(contact_query(1, a + 3, b + 3, offset, NULL, NULL, answer) == CONTACT_MISSING_GEOMETRY);
  a[0].size[0] = NAN;
  CHECK(contact_query(1, a, b, offset, NULL, NULL, answer));
  EXPECT(answer[0].status == CONTACT_REFUSED);

  CHECK(contact_law("hertz_mindlin", &law));
  CHECK(contact_mix(&soft, &soft, 1, &pair));
  soft.restitution = 2;
  EXPECT(contact_mix(&soft, &soft, 1, &pair) == CONTACT_BAD_VALUE);
  memset(motion, 0, sizeof motion);
  memset(history, 0, sizeof history);
  for (i = 0; i < 2; ++i) {
    motion[i].normal[0] = 1;
    motion[i].velocity[0] = 0.1;
    motion[i].velocity[1] = 0.3;
    motion[i].spin_a[0] = 5;
    motion[i].radius_eff = 0.005;
    motion[i].mass_eff = 0.001;
    motion[i].patch_spread[1] = motion[i].patch_spread[2] = i * 1e-6;
  }
  for (step = 1; step <= 5; ++step) {
    motion[0].overlap = 1e-6 * step;
    motion[1].overlap = 2e-6 * step;
    CHECK(contact_law_update(law, 2, &pair, 1, NULL, motion, 1e-5, NULL, history, load));
    for (i = 0; i < 2; ++i) {
      put("force", load[i].force, 3);
      put("couple", load[i].couple, 3);
    }
  }
  motion[1].overlap = 0;
  CHECK(contact_law_update(law, 2, &pair, 1, NULL, motion, 1e-5, NULL, history, load));
  EXPECT(load[1].force[0] == 0 && history[1].words[0] == 0 && history[0].words[3] != 0);
  contact_shape_free(cube);
  contact_shape_free(floor);
  contact_shape_free(tile);
  return 0;
}
