// Contact queries behind the C door.
#include <algorithm>
#include <cstring>

#include "libcontact/bindings/c/contact.h"
#include "libcontact/bindings/c/shape.h"
#include "libcontact/dispatch.h"
#include "libcontact/kernels/chunk.h"
#include "libcontact/laws/list.h"
#include "libcontact/methods/method.h"
#include "libcontact/version.h"

namespace {

using contact::Vec3d;
using shapes::Kind;

static_assert(static_cast<int>(contact::Status::separated) == CONTACT_SEPARATED &&
              static_cast<int>(contact::Status::touching) == CONTACT_TOUCHING &&
              static_cast<int>(contact::Status::overlapping) == CONTACT_OVERLAPPING &&
              static_cast<int>(contact::Status::not_converged) == CONTACT_NOT_CONVERGED &&
              static_cast<int>(contact::Status::refused) == CONTACT_REFUSED);
static_assert(sizeof(contact_cache) == 64 && sizeof(contact::Cache) <= sizeof(contact_cache));

bool needs_geometry(Kind k) {
  return k == Kind::polyhedron || k == Kind::rounded_polyhedron || k == Kind::potential_particle ||
         k == Kind::polygon || k == Kind::mesh;
}

int read(const contact_body& given, contact::Body& body) {
  if (given.kind >= shapes::kind_count) return CONTACT_BAD_VALUE;
  body.kind = static_cast<Kind>(given.kind);
  body.part = given.part;
  body.geometry = nullptr;
  if (needs_geometry(body.kind)) {
    body.geometry = given.shape == nullptr ? nullptr : given.shape->for_kind(body.kind);
    if (body.geometry == nullptr) return CONTACT_MISSING_GEOMETRY;
    if (body.kind == Kind::mesh && given.part >= static_cast<const shapes::Mesh*>(body.geometry)->facets.size())
      return CONTACT_BAD_VALUE;
  }
  body.size = {given.size[0], given.size[1], given.size[2]};
  const double* r = given.rotation;
  body.rotation.row[0] = {r[0], r[1], r[2]};
  body.rotation.row[1] = {r[3], r[4], r[5]};
  body.rotation.row[2] = {r[6], r[7], r[8]};
  return CONTACT_OK;
}

void put(double* out, const Vec3d& v) {
  out[0] = v.x;
  out[1] = v.y;
  out[2] = v.z;
}

void write(const contact::Contact& c, contact_answer& out) {
  out.status = static_cast<int32_t>(c.status);
  out.certified = c.certified ? 1 : 0;
  out.gap = c.gap;
  out.gap_lower = c.gap_lower;
  out.gap_upper = c.gap_upper;
  put(out.normal, c.normal);
  put(out.point_a, c.point_a);
  put(out.point_b, c.point_b);
  put(out.patch_centre, c.patch.centre);
  std::copy(std::begin(c.patch.spread), std::end(c.patch.spread), out.patch_spread);
  out.patch_weight = c.patch.weight;
  out.method_overlap = c.method_overlap;
  put(out.method_normal, c.method_normal);
  put(out.method_point, c.method_point);
  out.iterations = c.iterations;
  out.reserved = 0;
}

constexpr std::size_t chunk_size = contact::kernels::chunk_size;

// Pairs that follow one another and are of one pair of kinds, in kind order.
struct Chunk {
  std::size_t n = 0;
  contact::Body a[chunk_size], b[chunk_size];
  Vec3d offset[chunk_size];
  contact::Cache cache[chunk_size];
  contact::Contact answer[chunk_size];
  bool swapped = false;
};

}  // namespace

int contact_abi_version(void) { return CONTACT_ABI_VERSION; }
const char* contact_version(void) { return CONTACT_VERSION; }

const char* contact_error_text(int error) {
  switch (error) {
    case CONTACT_OK:
      return "no error";
    case CONTACT_NULL_POINTER:
      return "an array that is needed is a null pointer";
    case CONTACT_UNKNOWN_NAME:
      return "no kind, method or law of this name";
    case CONTACT_BAD_SIZE:
      return "an options structure whose size is none that this library knows";
    case CONTACT_MISSING_GEOMETRY:
      return "a body without the shape that its kind needs";
    case CONTACT_BAD_SHAPE:
      return "points that make no body";
    case CONTACT_NO_MEMORY:
      return "no memory";
    case CONTACT_BAD_VALUE:
      return "an index or a number out of range";
    default:
      return "no error of this library";
  }
}

int contact_kind(const char* name, uint32_t* kind) {
  if (name == nullptr || kind == nullptr) return CONTACT_NULL_POINTER;
  for (std::size_t i = 0; i < shapes::kind_count; ++i)
    if (std::strcmp(name, name_of(static_cast<Kind>(i))) == 0) {
      *kind = static_cast<uint32_t>(i);
      return CONTACT_OK;
    }
  return CONTACT_UNKNOWN_NAME;
}

int contact_query(size_t n, const contact_body* a, const contact_body* b, const double* offset,
                  const contact_query_options* options, contact_cache* caches, contact_answer* answers) {
  if (n == 0) return CONTACT_OK;
  if (a == nullptr || b == nullptr || offset == nullptr || answers == nullptr) return CONTACT_NULL_POINTER;
  contact::Options wanted;
  const char* method = nullptr;
  if (options != nullptr) {
    const bool full = options->size == sizeof(contact_query_options);
    if (!full && options->size != offsetof(contact_query_options, tolerance)) return CONTACT_BAD_SIZE;
    wanted = {.overlap_only = options->overlap_only != 0, .patch = options->patch != 0};
    if (full) wanted.tolerance = options->tolerance;
    if (!(wanted.tolerance >= 0 && wanted.tolerance <= 1)) return CONTACT_BAD_VALUE;
    method = options->method;
  }
  if (method != nullptr && std::strcmp(method, "auto") != 0 &&
      std::none_of(contact::methods_begin(), contact::methods_end(),
                   [&](const contact::MethodInfo& m) { return m.name == method; }))
    return CONTACT_UNKNOWN_NAME;
  Chunk c;
  for (std::size_t first = 0; first < n;) {
    // As many as are of one pair of kinds.
    for (c.n = 0; c.n < chunk_size && first + c.n < n; ++c.n) {
      const std::size_t i = first + c.n;
      const bool swapped = b[i].kind < a[i].kind;
      if (c.n > 0 && (swapped != c.swapped || a[i].kind != a[first].kind || b[i].kind != b[first].kind)) break;
      c.swapped = swapped;
      const Vec3d d{offset[3 * i], offset[3 * i + 1], offset[3 * i + 2]};
      if (const int error = read(swapped ? b[i] : a[i], c.a[c.n]); error != CONTACT_OK) return error;
      if (const int error = read(swapped ? a[i] : b[i], c.b[c.n]); error != CONTACT_OK) return error;
      c.offset[c.n] = swapped ? -d : d;
      if (caches != nullptr) std::memcpy(static_cast<void*>(&c.cache[c.n]), &caches[i], sizeof(contact::Cache));
    }
    const contact::ChunkQuery run =
        contact::find(c.a[0].kind, c.b[0].kind, method == nullptr ? "auto" : method, wanted.tolerance);
    if (run == nullptr)
      std::fill_n(c.answer, c.n, contact::refused());
    else
      run(c.n, c.a, c.b, c.offset, wanted, caches == nullptr ? nullptr : c.cache, c.answer);
    for (std::size_t k = 0; k < c.n; ++k) {
      if (c.swapped) contact::exchange(c.answer[k], -c.offset[k]);
      write(c.answer[k], answers[first + k]);
      if (caches != nullptr) std::memcpy(&caches[first + k], &c.cache[k], sizeof(contact::Cache));
    }
    first += c.n;
  }
  return CONTACT_OK;
}
