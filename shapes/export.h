// What the library lets others see: everything else is hidden, so that a linker resolves nothing against it by
// accident.
#pragma once

#if defined(__GNUC__)
#define SHAPES_API __attribute__((visibility("default")))
#else
#define SHAPES_API
#endif
