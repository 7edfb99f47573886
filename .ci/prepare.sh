# Shared by ./run, ./check and .ci/run (sourced by a POSIX shell, from the top of the project): install the packages that
# are missing, configure, build. Every command is printed before it runs; what is there already is left alone.

say() { printf '%s\n' "$*"; }

show() { # prints a command, then runs it
  printf '+ %s\n' "$*" >&2
  "$@"
}

show_logged() { # file command...: the same, what the command says is appended to the file
  log=$1
  shift
  printf '+ %s\n' "$*" >&2
  "$@" >>"$log" 2>&1
}

package_names() { # lists... -> one name per line
  sed 's/#.*//' "$@" | tr -s ' \t' '\n\n' | sed '/^$/d' | sort -u
}

missing_packages() { # lists... -> the names that are not installed
  # shellcheck disable=SC2046  # one word per package
  package_names "$@" | grep -vxF -- "$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' $(package_names "$@") 2>/dev/null |
    sed -n 's/^installed //p')"
}

install_packages() { # lists...
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    say "No apt on this machine: what $* name must come from elsewhere."
    return 0
  fi
  missing=$(missing_packages "$@" | tr '\n' ' ')
  if [ -z "$missing" ]; then
    say "Every package of $* is installed."
    return 0
  fi
  as_root=
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      say "Packages are missing and installing them needs root: apt-get install $missing" >&2
      return 1
    fi
    as_root=sudo
    [ -t 0 ] || as_root='sudo -n'
  fi
  mkdir -p build
  : >build/packages.log
  # shellcheck disable=SC2086  # both hold several words
  if show_logged build/packages.log $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 update &&
    show_logged build/packages.log $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300 \
      -o Dpkg::Use-Pty=0 install --no-install-recommends $missing; then
    return 0
  fi
  say "The packages could not be installed; the end of build/packages.log:" >&2
  tail -n 20 build/packages.log >&2
  return 1
}

# prepare PRESET LISTS... [-- TARGETS...]: packages, configuration, build (of everything when no target is named).
prepare() {
  preset=$1
  shift
  lists=
  while [ $# -gt 0 ] && [ "$1" != -- ]; do
    lists="$lists $1"
    shift
  done
  [ $# -eq 0 ] || shift
  # shellcheck disable=SC2086  # one word per list
  install_packages $lists || return
  show cmake --preset "$preset" || return
  if [ $# -gt 0 ]; then
    show cmake --build --preset "$preset" --target "$@"
  else
    show cmake --build --preset "$preset"
  fi
}

test_attribute() { # file name: an attribute of the first element of a JUnit report
  sed -n "s/.*[[:space:]]$2=\"\([0-9]*\)\".*/\1/p" "$1" | head -n 1
}

say_tests() { # prints the numbers; fails when no test ran
  say "Tests: $tests_passed passed, $tests_failed failed, $tests_skipped skipped"
  [ $((tests_passed + tests_failed)) -gt 0 ]
}

# count_tests FILE: sets tests_passed, tests_failed, tests_skipped from a JUnit report of ctest, names what was skipped and
# prints the numbers. Fails when no test ran.
count_tests() {
  tests_passed=0 tests_failed=0 tests_skipped=0
  if [ ! -s "$1" ]; then
    say "Tests: none ran." >&2
    return 1
  fi
  tests_failed=$(test_attribute "$1" failures)
  tests_skipped=$(($(test_attribute "$1" skipped) + $(test_attribute "$1" disabled)))
  tests_passed=$(($(test_attribute "$1" tests) - tests_failed - tests_skipped))
  if [ "$tests_skipped" -gt 0 ]; then
    say "Skipped:"
    sed -n 's/.*<testcase name="\([^"]*\)".*status="\(notrun\|disabled\)".*/  \1/p' "$1"
  fi
  say_tests
}

# sum_tests FILES: the same numbers from the reports that GoogleTest wrote, each of a part of the tests.
sum_tests() {
  tests_skipped=$(cat "$@" | grep -cE '<testcase .*(result="skipped"|status="notrun")')
  tests_failed=$(cat "$@" | awk '/<testcase / { failed = 0 } /<failure / && !failed { ++n; failed = 1 } END { print n + 0 }')
  tests_passed=$(($(cat "$@" | grep -c '<testcase ') - tests_skipped - tests_failed))
  say_tests
}
