# Read by run.sh and test.sh: goes to the top of the source tree, installs what is missing, and knows how to build.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

install_packages() {
    local wanted missing=()
    mapfile -t wanted < <(grep -v '^#' scripts/packages.txt | grep .)
    command -v dpkg-query apt-get > /dev/null || {
        echo "No apt here; the build needs what these Debian packages hold: ${wanted[*]}"
        return
    }
    local package
    for package in "${wanted[@]}"; do
        [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2> /dev/null) == installed ]] || missing+=("$package")
    done
    [[ ${#missing[@]} -eq 0 ]] && return
    echo "Installing ${missing[*]}"
    local as_root=()
    [[ $(id -u) -eq 0 ]] || as_root=(sudo)
    "${as_root[@]}" apt-get update -qq
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
}

# build PRESET [TARGET]: configures on the first call, then compiles what has changed.
build() {
    local launcher=()
    if command -v ccache > /dev/null; then
        launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
        export CCACHE_SLOPPINESS=pch_defines,time_macros # what it asks for to keep files that use precompiled headers
    fi
    cmake --preset "$1" "${launcher[@]}" > /dev/null
    cmake --build --preset "$1" ${2:+--target "$2"}
}

install_packages
