#!/bin/sh
# run.sh SOURCE BUILD WORK: installs BUILD into WORK and builds outside projects against what is there: CMake, pkg-config
# with make, C. Their answers must be those of the tree.
set -eu
source=$1 build=$2 work=$3
rm -rf "$work"
mkdir -p "$work/make"
prefix=$work/prefix
cmake --install "$build" --prefix "$prefix" >"$work/install.log"

example=$work/user.cpp # that of the page, as it stands there
awk '/^```cpp$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$source/libcontact/LINKING.md" >"$example"

echo "+ with CMake"
cmake -S "$source/tests/linkable/cmake" -B "$work/cmake" -DCMAKE_PREFIX_PATH="$prefix" -DEXAMPLE="$example" \
  -DSOURCES="$source/tests/linkable" -DCMAKE_BUILD_TYPE=Release >"$work/cmake.log"
cmake --build "$work/cmake" >>"$work/cmake.log"
"$work/cmake/user" | tee "$work/user.txt"
"$work/cmake/door" >"$work/door.txt"
"$work/cmake/same" >"$work/same.txt"
cmp "$work/door.txt" "$work/same.txt"
echo "C and C++ give the same bits: $(wc -l <"$work/door.txt") lines"

"$work/cmake/foreign"
echo "a shape, a method and a law of another program: every answer that of its formula"

echo "+ with pkg-config and make"
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name contact.pc)")
export PKG_CONFIG_PATH
make -s -C "$work/make" -f "$source/tests/linkable/make/Makefile" EXAMPLE="$example" user
"$work/make/user" | cmp - "$work/user.txt"

echo "+ the installed program and library run a scene as the tree does"
unset PKG_CONFIG_PATH
scene=$prefix/share/contact_mechanics/scenes/bodies_of_parts.toml
inside=$("$build/bin/dem" run "$source/libdem/scenes/bodies_of_parts.toml" --out "$work/inside" --quiet --set run.steps=50 | grep state_hash)
outside=$("$prefix/bin/dem" run "$scene" --out "$work/outside" --quiet --set run.steps=50 | grep state_hash)
test "$inside" = "$outside"
test "state_hash $("$work/cmake/scene" "$scene")" = "$outside"
echo "$outside"


echo "+ the prefix may be moved"
mv "$prefix" "$work/moved"
prefix=$work/moved
cp "$source/libdem/scenes/box_stack.toml" "$prefix/share/contact_mechanics/scenes/moved_here.toml"
"$prefix/bin/dem" list scenes | grep moved_here

echo "+ headers include nothing but the standard library and each other"
for header in $(cd "$prefix/include" && find shapes libcontact -name '*.h' ! -path '*/kernels/gather.h'); do
  echo "#include \"$header\""
done >"$work/all.cpp"
c++ -std=c++20 -fsyntax-only -I"$prefix/include" "$work/all.cpp"
