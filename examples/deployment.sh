#!/usr/bin/env bash
# What an integrator meets first, from start to end: examples/deployment.sh [MAPD PROBE]. Each step does what docs/operation.md says, and checks what
# comes of it; what this machine cannot do is skipped, and said. Builds the programs where none are named. Most steps need root, to become other users.
set -euo pipefail
cd "$(dirname "$0")/.."

step() { printf '\n-- %s\n' "$*"; }
skip() { printf 'SKIPPED: %s\n' "$*"; }
fail() { printf 'FAILED: %s\n' "$*" >&2; exit 1; }

if [ $# -ge 2 ]; then
    mapd=$1 probe=$2
else
    cargo build -q --workspace --bin mapd --bin planner_probe
    mapd="${CARGO_TARGET_DIR:-target}/debug/mapd" probe="${CARGO_TARGET_DIR:-target}/debug/planner_probe"
fi

# Users and a group that need no account: numbers are enough.
daemon_user=61003 driver=61001 stranger=61004 drivers=61002

# Other users may not enter a developer's folders.
work=$(mktemp -d)
chmod 755 "$work"
cp "$mapd" "$work/mapd"
cp "$probe" "$work/probe"
cp examples/maps/town.xodr "$work/"
chmod 755 "$work/mapd" "$work/probe"
chmod 644 "$work/town.xodr"
mkdir -m 777 "$work/cache"
export MAPD_PREFIX="mapddep$$_" MAPD_CACHE="$work/cache"
daemon=
finish() {
    [ -z "$daemon" ] || kill "$daemon" 2>/dev/null || true
    wait 2>/dev/null || true
    rm -rf "$work" "/dev/shm/${MAPD_PREFIX}root" /dev/shm/"${MAPD_PREFIX}"*
}
trap finish EXIT

# As a unit's User=, Group= and SupplementaryGroups= do it.
as() { # USER GROUPS COMMAND…
    local user=$1 groups=$2
    shift 2
    setpriv --reuid="$user" --regid="$user" --groups="$groups" --no-new-privs "$@"
}

# Starts a daemon with these arguments and returns once it serves.
serve() {
    "$@" 2>"$work/log" &
    daemon=$!
    for _ in $(seq 300); do
        grep -q serving "$work/log" && return
        kill -0 "$daemon" 2>/dev/null || { cat "$work/log" >&2; fail "the daemon ended"; }
        sleep 0.1
    done
    fail "the daemon does not serve"
}

stop() {
    kill -TERM "$daemon"
    wait "$daemon" || fail "the daemon ended with an error"
    daemon=
}

ask() { printf 'x,y\n50,-1.75\n' | "$@" query shm:town nearest --wait 5; }
expect_lane() { grep -q '1:0:-1' <<<"$1" || fail "expected lane 1:0:-1, found: $1"; }

step "one user: daemon and client"
serve "$work/mapd" --load "$work/town.xodr"
expect_lane "$(ask "$work/mapd")"
"$work/mapd" doctor --wait 5 || fail "doctor finds a problem"

step "a client in a container with a read-only /dev/shm"
if unshare --mount true 2>/dev/null; then
    # shellcheck disable=SC2016
    answer=$(printf 'x,y\n50,-1.75\n' | unshare --mount sh -c '
        mount --bind /dev/shm /dev/shm && mount -o remount,bind,ro /dev/shm || exit 3
        touch /dev/shm/mapd-writes 2>/dev/null && exit 4
        exec "$0" query shm:town nearest --wait 5' "$work/mapd")
    expect_lane "$answer"
else
    skip "this user may not make a mount namespace"
fi

step "the same in a process namespace of its own, as another release with a table more serves it"
stop
"$work/mapd" compile "$work/town.xodr" -o "$work/own.mapd"
"$work/probe" release "$work/own.mapd" "$work/town.mapd"
serve "$work/mapd" --load "$work/town.mapd"
grep 'is not known' "$work/log" || fail "no word of the table that this release does not know"
own=$("$work/mapd" query "$work/own.mapd" nearest <<<$'x,y\n50,-1.75')
if unshare --mount --pid --fork true 2>/dev/null; then
    # shellcheck disable=SC2016
    answer=$(printf 'x,y\n50,-1.75\n' | unshare --mount --pid --fork --mount-proc sh -c '
        mount --bind /dev/shm /dev/shm && mount -o remount,bind,ro /dev/shm || exit 3
        exec "$0" query shm:town nearest --wait 5' "$work/mapd")
else
    skip "this user may not make a process namespace"
    answer=$(ask "$work/mapd")
fi
expect_lane "$answer"
[ "$answer" = "$own" ] || fail "expected as of the own release: $own, found: $answer"
stop
serve "$work/mapd" --load "$work/town.xodr"

step "a client that locks all its memory, with a limit that is too small, and with one that is not"
if told=$(ulimit -l 64 && setpriv --bounding-set=-ipc_lock --inh-caps=-ipc_lock "$work/probe" locked town 2>&1); then
    fail "a map larger than the limit was locked: $told"
elif grep -q 'LimitMEMLOCK' <<<"$told"; then
    echo "$told"
else
    fail "no word of the limit: $told"
fi
"$work/probe" locked town || fail "a client that may lock enough does not attach"
stop

if [ "$(id -u)" != 0 ] || ! as "$driver" "$drivers" test -x "$work/mapd"; then
    skip "second users: this user may not start processes of others"
    exit 0
fi

step "a daemon with User=, and clients of other users in its group"
# Not by the function: it would run in a shell of its own, which `stop` would end instead of the daemon.
serve setpriv --reuid="$daemon_user" --regid="$daemon_user" --groups="$drivers" --no-new-privs "$work/mapd" --load "$work/town.xodr" --share "group:$drivers"
export MAPD_OWNER=$daemon_user
expect_lane "$(ask as "$driver" "$drivers" "$work/mapd")"
as "$driver" "$drivers" "$work/mapd" status | grep -q '^town ' || fail "no status for a member"
as "$driver" "$drivers" "$work/mapd" doctor --wait 5 || fail "doctor finds a problem as a member"
if told=$(ask as "$stranger" "$stranger" "$work/mapd" 2>&1); then
    fail "a user of no group reads the map"
fi
grep -q 'may not read' <<<"$told" || fail "no word of the group: $told"
echo "$told"
if told=$(MAPD_OWNER=$driver ask as "$driver" "$drivers" "$work/mapd" 2>&1); then
    fail "a client trusts a daemon that it has not named"
fi
grep -q -- '--owner' <<<"$told" || fail "no word of the owner: $told"
echo "$told"

step "a group that the daemon's user is not in"
if told=$(MAPD_PREFIX="mapddeq$$_" MAPD_OWNER=$daemon_user as "$daemon_user" "$daemon_user" "$work/mapd" --load "$work/town.xodr" --share "group:$drivers" 2>&1); then
    fail "files were given to a group that the user is not in"
fi
grep -q 'not in it' <<<"$told" || fail "no word of the group: $told"
echo "$told"
stop

step "the units, and their drop-ins for other users"
units=examples/systemd
if command -v systemd-analyze >/dev/null; then
    for unit in mapd planner; do
        mkdir -p "$work/units/$unit.service.d"
        # The programs and users of the units are not here.
        local_names='s#/usr/bin/[a-z]*#/bin/true#; s#^\(User\|Group\|SupplementaryGroups\)=.*#\1=root#'
        sed "$local_names" "$units/$unit.service" >"$work/units/$unit.service"
        sed "$local_names" "$units/other-users/$unit.conf" >"$work/units/$unit.service.d/other-users.conf"
    done
    told=$(timeout 60 systemd-analyze verify --man=no "$work/units/mapd.service" "$work/units/planner.service" 2>&1) || fail "systemd-analyze: $told"
    # What it does not understand is only a warning to it.
    [ -z "$told" ] || fail "systemd-analyze: $told"
    echo "systemd-analyze verify finds nothing"
else
    skip "systemd-analyze is not here"
fi
step "the units under a systemd of their own"
verdict=0
examples/systemd/boot "$mapd" || verdict=$?
case $verdict in
    0) ;;
    77) skip "systemd cannot be booted here" ;;
    *) fail "what systemd makes of the units" ;;
esac
step "done"
