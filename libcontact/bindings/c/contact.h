/* libcontact for C and for everything that calls C: batches of contact queries and of law updates on arrays that the
 * caller owns. The same code and the same bits as behind contact.h and laws/law.h, where every quantity is defined.
 *
 * Units: SI. Vectors are three doubles along world axes, rotations nine, row by row, body to world. "Relative to a":
 * from the origin of body a.
 * Errors: functions return CONTACT_OK (0) or a code of contact_error_text; nothing is thrown. What a single pair or
 * contact brings (a NaN, a pair without a method) is no error of the call: its status says so.
 * Memory: queries and updates allocate nothing. Caches and histories are plain bytes of the caller: to be copied, kept
 * in files of one ABI version, forgotten by setting them to zero. Shapes are made by contact_shape_* and live until
 * contact_shape_free.
 * Threads: every function may run in any number of threads at once, as long as no two write to the same array. Shapes
 * are read only.
 * ABI: structures named *_options and contact_material begin with their size, so that they may grow; the others stay as
 * they are as long as contact_abi_version() is CONTACT_ABI_VERSION.
 * Cost: that of the C++ call and about 20 ns per pair. Test: tests/linkable. */
#ifndef LIBCONTACT_BINDINGS_C_CONTACT_H
#define LIBCONTACT_BINDINGS_C_CONTACT_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define CONTACT_C_API __attribute__((visibility("default")))
#else
#define CONTACT_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define CONTACT_ABI_VERSION 1

enum contact_error {
  CONTACT_OK = 0,
  CONTACT_NULL_POINTER = 1,     /* an array that is needed is not there */
  CONTACT_UNKNOWN_NAME = 2,     /* no such kind, method or law */
  CONTACT_BAD_SIZE = 3,         /* an options structure of an unknown size */
  CONTACT_MISSING_GEOMETRY = 4, /* a body of a kind that needs a shape has none, or one of another kind */
  CONTACT_BAD_SHAPE = 5,        /* points that make no body; the message says why */
  CONTACT_NO_MEMORY = 6,
  CONTACT_BAD_VALUE = 7 /* an index or a number out of range */
};

enum contact_status {
  CONTACT_SEPARATED = 0,
  CONTACT_TOUCHING = 1,
  CONTACT_OVERLAPPING = 2,
  CONTACT_NOT_CONVERGED = 3,
  CONTACT_REFUSED = 4
};

CONTACT_C_API int contact_abi_version(void);
CONTACT_C_API const char* contact_version(void); /* "0.1.0" */
CONTACT_C_API const char* contact_error_text(int error);

/* Numbers of a kind of body ("sphere", "ellipsoid", "polyhedron", …) and of a law ("hertz_mindlin", …); valid for this
 * library as loaded, not for files. */
CONTACT_C_API int contact_kind(const char* name, uint32_t* kind);
CONTACT_C_API int contact_law(const char* name, uint32_t* law);

/* Shapes that a few numbers do not give. `principal` != 0: in the principal frame, else as given. On CONTACT_BAD_SHAPE
 * the message (may be null) holds the reason, cut to message_size with its closing zero. */
typedef struct contact_shape contact_shape;
CONTACT_C_API int contact_shape_polyhedron(const double* points, size_t count, int principal, contact_shape** shape,
                                           char* message, size_t message_size);
CONTACT_C_API int contact_shape_polygon(const double* outline /* x, y */, size_t count, contact_shape** shape,
                                        char* message, size_t message_size);
CONTACT_C_API int contact_shape_mesh(const double* vertices, size_t vertex_count, const uint32_t* triangles,
                                     size_t triangle_count, contact_shape** shape, char* message, size_t message_size);
CONTACT_C_API int contact_shape_potential(const double* half_spaces /* normal, offset */, size_t count, double k,
                                          double r, double R, int principal, contact_shape** shape, char* message,
                                          size_t message_size);
CONTACT_C_API void contact_shape_free(contact_shape* shape);

typedef struct contact_body {
  uint32_t kind;
  uint32_t part;              /* mesh: the facet */
  const contact_shape* shape; /* kinds that need one */
  double size[3]; /* as contact::Body::size: sphere (radius, -, -), ellipsoid semi-axes, polyhedron (scale, -, -) */
  double rotation[9];
} contact_body;

typedef struct contact_cache { /* of one pair; all zero: nothing known. Any content gives the same answer */
  uint64_t words[8];
} contact_cache;

typedef struct contact_query_options {
  size_t size;        /* sizeof(contact_query_options) */
  int overlap_only;   /* != 0: a separated pair may stop at the first proof */
  int patch;          /* != 0: the patch of an overlap too */
  const char* method; /* null: the production method */
  double tolerance;   /* without a method: the cheapest that proves the gap to this part of the smaller circumradius; 0:
                         exact. A smaller structure may leave it out */
} contact_query_options;

typedef struct contact_answer { /* as contact::Contact */
  int32_t status;               /* contact_status */
  int32_t certified;
  double gap, gap_lower, gap_upper; /* m */
  double normal[3];                 /* from a to b */
  double point_a[3], point_b[3];    /* m, relative to a, as are the other points */
  double patch_centre[3];           /* where the force acts */
  double patch_spread[6];           /* m²: xx, yy, zz, xy, xz, yz */
  double patch_weight;              /* m³; 0 of a point */
  double method_overlap;            /* m, what the method itself measures */
  double method_normal[3], method_point[3];
  int32_t iterations;
  int32_t reserved;
} contact_answer;

/* n pairs, of any kinds in any order: answers[i] of (a[i], b[i]), offset[3 i …] = origin of b less origin of a.
 * `options` null: everything. `caches` null, or n of them. */
CONTACT_C_API int contact_query(size_t n, const contact_body* a, const contact_body* b, const double* offset,
                                const contact_query_options* options, contact_cache* caches, contact_answer* answers);

typedef struct contact_material {
  size_t size;        /* sizeof(contact_material) */
  double young;       /* Pa */
  double poisson;     /* - */
  double restitution; /* - */
  double friction;    /* - */
  double stiffness;   /* N/m, of spring_dashpot */
  int rigid;          /* != 0: left out of the effective moduli */
} contact_material;

typedef struct contact_pair { /* as contact::PairParameters */
  double young_eff, shear_eff, stiffness_n, stiffness_t, friction, damping, restitution;
} contact_pair;

/* How two materials meet, once per pair. clip != 0: contacts end at zero force, else at zero overlap. */
CONTACT_C_API int contact_mix(const contact_material* a, const contact_material* b, int clip, contact_pair* pair);

typedef struct contact_law_options {
  size_t size; /* sizeof(contact_law_options) */
  int rescale; /* != 0: the tangential spring is shortened as the contact radius shrinks */
  int clip;    /* as of contact_mix */
} contact_law_options;

typedef struct contact_history { /* of one contact, one cache line; all zero: not touching */
  uint64_t words[8];
} contact_history;

typedef struct contact_motion {
  double overlap;         /* m; not above 0: the history is forgotten, the load is zero */
  double normal[3];       /* unit, a to b */
  double velocity[3];     /* of a relative to b at the contact's centre, m/s */
  double spin_a[3];       /* rad/s */
  double spin_b[3];       /* rad/s */
  double radius_eff;      /* R* = Ra Rb / (Ra + Rb), m */
  double mass_eff;        /* m*, kg */
  double patch_spread[6]; /* m²; zero of a point */
} contact_motion;

typedef struct contact_load {
  double force[3];  /* on a at the contact's centre, N; on b the opposite */
  double couple[3]; /* on a besides the force's moment, N m; on b the opposite */
} contact_load;

/* n contacts over a step dt (s; 0: evaluate, nothing slips). pairs[pair_of[i]] is how they meet; pair_of null:
 * pairs[0] for all. `options` null: both on. */
CONTACT_C_API int contact_law_update(uint32_t law, size_t n, const contact_pair* pairs, size_t pair_count,
                                     const uint32_t* pair_of, const contact_motion* motions, double dt,
                                     const contact_law_options* options, contact_history* histories,
                                     contact_load* loads);

#ifdef __cplusplus
}
#endif
#endif
