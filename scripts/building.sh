# Sourced by the other scripts.

# cmake --build with these arguments: its last line, or all that the compiler says where it fails.
build() {
    local said
    said=$(cmake --build "$@" 2>&1) || { echo "$said"; return 1; }
    tail -n 1 <<<"$said"
}
