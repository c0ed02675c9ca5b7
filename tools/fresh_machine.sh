#!/bin/sh
# Does a clone work on a machine that has nothing? Puts the committed state onto a minimal Debian 12
# and runs the README's two commands there, as root and to the end; says what failed, which package
# was missing and how long each took. Needs root, debootstrap and 6 GB; about an hour on two cores.
#   tools/fresh_machine.sh [--quick] [--keep] [FOLDER]
#     --quick  the first command stops the wash after 0.2 s of its 19 s
#     --keep   the machine stays in FOLDER (default: a new one below $TMPDIR) for a look at it
# Packages come from where this machine has them: apt's sources of Debian, npm's configuration,
# certificates, proxies. Mounts live in a name space of their own and end with the command.
set -eu

root=$(cd "$(dirname "$0")/.." && pwd)
quick= keep= folder=
for argument in "$@"; do
  case $argument in
    --quick) quick=1 ;;
    --keep) keep=1 ;;
    -*) sed -n '2,/^set/s/^# \{0,1\}//p' "$0" >&2 && exit 2 ;;
    *) folder=$argument ;;
  esac
done

say() { echo "fresh machine: $*"; }
stop() {
  say "$*" >&2
  exit 1
}

[ "$(id -u)" -eq 0 ] || stop "only root can make one"
for tool in debootstrap unshare git; do
  command -v $tool >/dev/null || stop "$tool is missing here: apt-get install debootstrap util-linux git"
done
[ -z "$folder" ] || [ ! -e "$folder" ] || stop "$folder is there already"
[ -n "$folder" ] || folder=$(mktemp -d)/debian
mkdir -p "$folder"
machine=$(cd "$folder" && pwd)
# The machine's processes and mounts end with each command, so that nothing of this one is deleted.
[ -n "$keep" ] || trap 'rm -rf --one-file-system "$machine"' EXIT
trap 'exit 130' INT TERM HUP

own_space() { unshare --mount --pid --fork --kill-child "$@"; }

# Debian's lines of this machine's sources, "URI release component" each.
debian_sources() {
  apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' \
    'Created-By: Packages' 'Origin: Debian' | grep ' bookworm' | sort -u
}

bare_debian() {
  mirror=$(debian_sources | awk '$2 == "bookworm" { print $1; exit }')
  [ -n "$mirror" ] || stop "apt has no source of Debian 12 (bookworm) here"
  own_space debootstrap --variant=minbase bookworm "$machine" "$mirror" >"$machine.log" 2>&1 ||
    { tail -n 20 "$machine.log" >&2; stop "debootstrap failed"; }
  debian_sources | sed 's/^/deb /' >"$machine/etc/apt/sources.list"
}

# What lets apt and npm reach their registries: installing ca-certificates would replace the usual bundle.
pass_in() {
  mkdir -p "$machine/host"
  apt-config dump | grep -E '^Acquire::(https?|Retries|ForceIP)' >"$machine/etc/apt/apt.conf.d/50host" || true
  if [ -s /etc/ssl/certs/ca-certificates.crt ]; then
    cp -L /etc/ssl/certs/ca-certificates.crt "$machine/host/certificates.crt"
    echo 'Acquire::https::CAInfo "/host/certificates.crt";' >>"$machine/etc/apt/apt.conf.d/50host"
  fi
  cp -L /etc/resolv.conf /etc/hosts "$machine/etc/"
  ! command -v npm >/dev/null || for level in global user; do
    file=$(npm config get ${level}config)
    [ ! -f "$file" ] || cp "$file" "$machine/host/npmrc-$level"
  done
}

# Runs a command in the clone with the environment of a fresh log-in; the shell stays, as its init.
inside() {
  own_space sh -c '
    machine=$1
    shift
    mount -t proc proc "$machine/proc"
    mount --rbind /sys "$machine/sys"
    mount --rbind /dev "$machine/dev"
    mount -t tmpfs shm "$machine/dev/shm"
    bundle=/host/certificates.crt
    [ -f "$machine$bundle" ] || bundle=
    cd / && chroot "$machine" env -i -C /root/washtub HOME=/root TERM=dumb \
      PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
      ${bundle:+NODE_EXTRA_CA_CERTS=$bundle npm_config_cafile=$bundle} \
      npm_config_globalconfig=/host/npmrc-global npm_config_userconfig=/host/npmrc-user \
      ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} \
      ${no_proxy:+no_proxy="$no_proxy"} "$@"
    exit $?' sh "$machine" "$@"
}

# Lines of a log that tell of something missing; with the package that has it here.
missing() {
  grep -hE 'No such file or directory|not found|[Cc]ould not (find|locate)|NOTFOUND|is missing:|cannot open shared' "$@" |
    grep -vE '^-- ' | sort -u | head -n 20 | while read -r line; do
    say "  $line"
    header=$(echo "$line" | sed -n 's/.*fatal error: \(.*\): No such file.*/\1/p')
    [ -z "$header" ] || dpkg -S "*/$header" 2>/dev/null | sed 's/^/    here it is of /'
  done
}

# attempt NUMBER COMMAND...: one of the README's commands, its time, and what it lacked.
attempt() {
  number=$1
  shift
  say "$*"
  log=$machine.$number.log
  begin=$(date +%s)
  code=0
  inside "$@" </dev/null >"$log" 2>&1 || code=$?
  taken=$(($(date +%s) - begin))
  say "$(printf 'exit code %d after %d min %02d s' $code $((taken / 60)) $((taken % 60)))"
  if [ $code -ne 0 ]; then
    failed=1
    tail -n 40 "$log"
    say "what it says of missing things:"
    missing "$log" "$machine/root/washtub/build/build.log" || true
  fi
  grep -E 'Skipped|tests passed' "$log" || true
}

begin_all=$(date +%s)
failed=0
bare_debian
pass_in
git clone --quiet --no-hardlinks "$root" "$machine/root/washtub"
say "Debian $(cat "$machine/etc/debian_version") with $(chroot "$machine" dpkg-query -W | wc -l) packages, commit $(git -C "$root" rev-parse --short HEAD)"

# shellcheck disable=SC2016
attempt 1 ./washtub run cases/wash-3d/case.toml \
  ${quick:+--set 'time.end=0.2 s' --set 'output.window=["0.1 s","0.2 s"]'}
attempt 2 ./washtub test
say "$(chroot "$machine" dpkg-query -W | wc -l) packages at the end, $((($(date +%s) - begin_all) / 60)) min in all"
say "logs: $machine.1.log and $machine.2.log"
[ $failed -eq 0 ] && say "both commands succeed" || say "something failed, see above"
exit $failed
