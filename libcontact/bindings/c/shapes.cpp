// Shapes for the C door.
#include <cstring>
#include <new>
#include <vector>

#include "libcontact/bindings/c/contact.h"
#include "libcontact/bindings/c/shape.h"
#include "shapes/mesh_build.h"
#include "shapes/polygon_build.h"
#include "shapes/polyhedron_build.h"
#include "shapes/potential_build.h"

namespace {

using shapes::Vec3d;

template <class Build>
int make(Build build, contact_shape** shape, char* message, std::size_t message_size) noexcept {
  if (shape == nullptr) return CONTACT_NULL_POINTER;
  *shape = nullptr;
  try {
    *shape = new contact_shape{build()};
    return CONTACT_OK;
  } catch (const std::bad_alloc&) {
    return CONTACT_NO_MEMORY;
  } catch (const std::exception& error) {
    if (message != nullptr && message_size > 0) {
      const std::size_t length = std::min(std::strlen(error.what()), message_size - 1);
      std::memcpy(message, error.what(), length);
      message[length] = 0;
    }
    return CONTACT_BAD_SHAPE;
  }
}

std::vector<Vec3d> points(const double* given, std::size_t count, std::size_t dimension) {
  std::vector<Vec3d> out(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < dimension; ++k) out[i][static_cast<int>(k)] = given[dimension * i + k];
  return out;
}

std::vector<shapes::HalfSpace> planes(const double* given, std::size_t count) {
  std::vector<shapes::HalfSpace> out;
  for (std::size_t i = 0; i < count; ++i)
    out.push_back({{given[4 * i], given[4 * i + 1], given[4 * i + 2]}, given[4 * i + 3]});
  return out;
}

shapes::Frame frame(int principal) { return principal != 0 ? shapes::Frame::principal : shapes::Frame::as_given; }

}  // namespace

int contact_shape_polyhedron(const double* given, size_t count, int principal, contact_shape** shape, char* message,
                             size_t message_size) {
  if (given == nullptr) return CONTACT_NULL_POINTER;
  return make([&] { return shapes::polyhedron_from_points(points(given, count, 3), frame(principal)); }, shape, message,
              message_size);
}

int contact_shape_polygon(const double* outline, size_t count, contact_shape** shape, char* message,
                          size_t message_size) {
  if (outline == nullptr) return CONTACT_NULL_POINTER;
  return make([&] { return shapes::polygon_from_outline(points(outline, count, 2)); }, shape, message, message_size);
}

int contact_shape_mesh(const double* vertices, size_t vertex_count, const uint32_t* triangles, size_t triangle_count,
                       contact_shape** shape, char* message, size_t message_size) {
  if (vertices == nullptr || triangles == nullptr) return CONTACT_NULL_POINTER;
  return make(
      [&] {
        return shapes::mesh_from_triangles(points(vertices, vertex_count, 3), {triangles, 3 * triangle_count});
      },
      shape, message, message_size);
}

int contact_shape_potential(const double* half_spaces, size_t count, double k, double r, double R, int principal,
                            contact_shape** shape, char* message, size_t message_size) {
  if (half_spaces == nullptr) return CONTACT_NULL_POINTER;
  return make([&] { return shapes::make_potential_particle(planes(half_spaces, count), k, r, R, frame(principal)); },
              shape, message, message_size);
}

void contact_shape_free(contact_shape* shape) { delete shape; }
