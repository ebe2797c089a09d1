#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs README's commands where nothing of ours is installed: a bare Debian 12 in a temporary folder (mmdebstrap), the committed
# HEAD cloned into it, `make TARGET` inside, everything removed at the end.
#   tools/bare_machine.sh [TARGET|VARIABLE=VALUE]...      targets: demo test unless named; variables go to every make
# Stops at the first target that fails, with its exit code. Needs root and the right to mount (a virtual machine, or a container
# that may: docker run --privileged). Packages come from where this machine's apt takes Debian's, with its proxy.
set -euo pipefail
cd "$(dirname "$0")/.."
fail() {
    echo "bare_machine: $*" >&2
    exit 1
}

targets=() variables=()
for word in "$@"; do
    case $word in
    -*) sed -n '3,7s/^# \{0,1\}//p' "$0" >&2 && exit 2 ;;
    *=*) variables+=("$word") ;;
    *) targets+=("$word") ;;
    esac
done
[ ${#targets[@]} -gt 0 ] || targets=(demo test)
if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null 2>&1 || fail "must run as root"
    exec sudo -- "$0" "$@"
fi
tools/install_deps.sh bare-machine
unshare --mount --pid --fork true 2>/dev/null || fail "this machine lets nobody mount (unshare --mount)"
[ -z "$(git status --porcelain)" ] || echo "bare_machine: HEAD is tested, without what is not committed" >&2

# All mounts are made in a namespace of their own and vanish with its last process; only then is the folder removed.
work=$(mktemp -d)
chmod 755 "$work"
child=
finish() {
    [ -z "$child" ] || { kill -TERM "$child" && wait "$child"; } 2>/dev/null || true
    rm -rf --one-file-system "$work"
}
trap finish EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP
inside() { # inside COMMAND...: in the namespace, as a child that a signal to us does not outlive
    unshare --mount --propagation private --pid --fork --kill-child -- "$@" </dev/null &
    child=$!
    local status=0
    wait "$child" || status=$?
    child=
    return "$status"
}

# Debian's part of this machine's sources, else the public mirror; other sources are not ours to need.
sources() {
    # shellcheck disable=SC2016
    apt-get indextargets --format 'deb $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' \
        2>/dev/null | grep ' bookworm' | sort -u || true
}
debian=$(sources)
[ -n "$debian" ] || { apt-get update -qq && debian=$(sources); } || true
[ -n "$debian" ] || debian='deb http://deb.debian.org/debian bookworm main'
echo "$debian" >"$work/sources.list"
apt-config dump | grep '^Acquire::' | grep -v -e '""' -e IndexTargets -e Changelogs -e CompressionTypes >"$work/apt.conf" || true

started=$SECONDS
root=$work/root
inside mmdebstrap --quiet --mode=root --variant=minbase --include=make,ca-certificates,git --aptopt="$work/apt.conf" \
    bookworm "$root" "$work/sources.list" || fail "mmdebstrap failed"
cp /etc/hosts "$root/etc/hosts"
git clone -q --depth 1 "file://$PWD" "$root/root/pantin"
times="bare Debian 12 $((SECONDS - started)) s"

# One target, with the little that a machine has beyond its files.
cat >"$work/make" <<'END'
set -eu
root=$1
shift
mount -t proc proc "$root/proc"
mount -t tmpfs tmpfs "$root/dev/shm"
mkdir -p "$root/dev/pts" && mount -t devpts devpts "$root/dev/pts"
exec env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 CI="${CI:-}" chroot "$root" sh -c 'cd /root/pantin && exec make "$@"' - "$@"
END
for target in "${targets[@]}"; do
    started=$SECONDS
    status=0
    inside sh "$work/make" "$root" "$target" "${variables[@]}" || status=$?
    times="$times, make $target $((SECONDS - started)) s"
    if [ "$status" != 0 ]; then
        echo "bare machine: $times: FAILED with exit code $status"
        exit "$status"
    fi
done
echo "bare machine: $times"
