# Sourced by ./run, ./test and .ci/run: installs the packages of packages.txt and builds. Expects `root` to be set.

# Packages of the list that are not installed; empty when all are.
missing_packages() {
  local wanted
  wanted=$(grep -v '^#' "$root/third_party/packages.txt")
  # shellcheck disable=SC2086
  { dpkg-query -W -f='${Package} ${db:Status-Abbrev}\n' $wanted 2>/dev/null || true; } |
    awk '$2 == "ii" {print $1}' | sort -u | comm -13 - <(printf '%s\n' $wanted | sort -u)
}

install_packages() {
  local stamp="$root/build/packages.stamp" missing
  # Asking dpkg takes a while: only when the list changed since it was found complete.
  if [ -f "$stamp" ] && cmp -s "$stamp" "$root/third_party/packages.txt"; then
    return
  fi
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "This script installs packages with apt (Debian, Ubuntu). Elsewhere install what third_party/packages.txt names and build with CMake." >&2
    exit 1
  fi
  missing=$(missing_packages)
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

# build TARGET...: configures when needed; quiet unless something is to be built or fails.
build() {
  local folder="$root/build/release" log="$root/build/build.log"
  if [ ! -f "$folder/build.ninja" ]; then
    echo "Configuring ..."
    (cd "$root" && cmake --preset release) >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
  fi
  ninja -C "$folder" "$@" >"$log" 2>&1 &
  local job=$! waited
  # Told only where there is something to build: finding that there is not takes a moment.
  for waited in $(seq 20); do
    kill -0 "$job" 2>/dev/null || break
    sleep 0.05
  done
  if kill -0 "$job" 2>/dev/null; then
    echo "Building ..."
  fi
  wait "$job" || { grep -E 'error|FAILED|undefined' "$log" >&2 || tail -n 40 "$log" >&2; exit 1; }
}
