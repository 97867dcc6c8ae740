# Sourced by ./run, ./test, ./package and .ci/run: installs the packages of packages.txt and builds. Expects `root` to be set.

# wanted_packages run|test|package: names of the list that this goal needs.
wanted_packages() {
  awk -v goal="$1" '!/^#/ && NF && (NF == 1 || $2 == goal) {print $1}' "$root/third_party/packages.txt" | sort -u
}

# Packages of the list that are not installed; empty when all are.
missing_packages() {
  local wanted
  wanted=$(wanted_packages "$1")
  # shellcheck disable=SC2086
  { dpkg-query -W -f='${Package} ${db:Status-Abbrev}\n' $wanted 2>/dev/null || true; } |
    awk '$2 == "ii" {print $1}' | sort -u | comm -13 - <(printf '%s\n' $wanted)
}

# install_packages run|test|package
install_packages() {
  local stamp="$root/build/packages.$1.stamp" missing
  # Asking dpkg takes a while: only when the list changed since it was found complete.
  if [ -f "$stamp" ] && cmp -s "$stamp" "$root/third_party/packages.txt"; then
    return
  fi
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "This script installs packages with apt (Debian, Ubuntu). Elsewhere install what third_party/packages.txt names and build with CMake." >&2
    exit 1
  fi
  missing=$(missing_packages "$1")
  if [ -n "$missing" ]; then
    local as_root=""
    if [ "$(id -u)" -ne 0 ]; then
      as_root="sudo"
      echo "sudo is needed to install these packages:" $missing
    else
      echo "Installing:" $missing
    fi
    $as_root apt-get update -qq
    # shellcheck disable=SC2086
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
  fi
  mkdir -p "$root/build"
  cp "$root/third_party/packages.txt" "$stamp"
}

# show_progress JOB LOG: per cent of the build that is done, as long as the job runs. A terminal keeps one line; elsewhere a
# line for every quarter.
show_progress() {
  local job=$1 log=$2 percent told=-1
  while kill -0 "$job" 2>/dev/null; do
    percent=$(tail -n 1 "$log" 2>/dev/null | sed -nE 's/^ *([0-9]+)%.*/\1/p')
    if [ -n "$percent" ] && [ -t 1 ]; then
      printf '\rBuilding ... %3d %%' "$percent"
    elif [ -n "$percent" ] && [ "$((percent / 25))" -gt "$told" ]; then
      told=$((percent / 25))
      echo "Building ... $percent %"
    fi
    sleep 0.3
  done
  [ ! -t 1 ] || printf '\r                    \r'
}

# configure run|test|package: where it was not done yet, for a package always. Once the tests are part of the build folder they stay.
configure() {
  local folder="$root/build/release" log="$root/build/build.log" tests=(-DSTRETCH_TESTS=OFF)
  if [ "$1" = test ]; then
    tests=(-DSTRETCH_TESTS=ON)
  fi
  if [ -f "$folder/build.ninja" ]; then
    case $1 in
      run) return ;;
      test) ! grep -q '^STRETCH_TESTS:BOOL=ON' "$folder/CMakeCache.txt" || return 0 ;;
      package) tests=() ;; # tools that it installed are looked for again
    esac
  fi
  echo "Configuring ..."
  (cd "$root" && cmake --preset release "${tests[@]}") >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
}

# build TARGET...: quiet unless something is to be built or fails.
build() {
  local folder="$root/build/release" log="$root/build/build.log"
  : >"$log"
  NINJA_STATUS='%p ' ninja -C "$folder" "$@" >"$log" 2>&1 &
  local job=$! waited
  # Told only where there is something to build: finding that there is not takes a moment.
  for waited in $(seq 20); do
    kill -0 "$job" 2>/dev/null || break
    sleep 0.05
  done
  show_progress "$job" "$log"
  wait "$job" || { grep -E 'error|FAILED|undefined' "$log" >&2 || tail -n 40 "$log" >&2; exit 1; }
}
