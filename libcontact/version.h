// The version of the toolkit: of its libraries, its program, and the files that it writes. Semantic: within one major
// version (0.x: one minor version) programs that were linked against an older one go on to run.
#pragma once

#define CONTACT_VERSION_MAJOR 0
#define CONTACT_VERSION_MINOR 1
#define CONTACT_VERSION_PATCH 0
#define CONTACT_VERSION "0.1.0"
