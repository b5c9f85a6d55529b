#!/usr/bin/env bash
# Rendering by the ranks of an MPI run, over a source that needs no renderer. usage: render_mpi.sh FOLDER_OF_PROGRAMS
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
programs=$(realpath -- "${1:?usage: render_mpi.sh FOLDER_OF_PROGRAMS}")
fake=$programs/fake_render_mpi
if ! type -P mpirun >/dev/null; then
  echo 'no mpirun: nothing is tested'
  exit 0
fi
export HWLOC_COMPONENTS=-gl # as the script has it: displays of other tests come and go
mpi=(timeout 60 mpirun --oversubscribe --mca odls_base_sigkill_timeout 1)
[[ $(id -u) != 0 ]] || mpi+=(--allow-run-as-root)
job=(teapot:1 --size 100x80 --samples 16 --error 0.02 --aov "depth,cost" --out a.exr)

run "$programs/fake_render" "${job[@]}"
expect_exit 0
cp "$work/a.exr" "$scratch/whole.exr"
is_whole() { check 'the same bytes as by one process' cmp "$work/a.exr" "$scratch/whole.exr"; }

for ranks in 1 2 3 4; do
  run "${mpi[@]}" -np $ranks "$fake" "${job[@]}"
  expect_exit 0
  check 'one line at the end' test "$(grep -c 'samples a pixel' "$scratch/stderr")" = 1
  is_whole
done
run "${mpi[@]}" -np 3 "$fake" --help
expect_exit 0
check 'one help' test "$(grep -c -x Options: "$scratch/stdout")" = 1
run "${mpi[@]}" -np 3 "$fake" teapot:1 --plan
expect_exit 0
check 'one plan' test "$(wc -l <"$scratch/stdout")" = 1
run "${mpi[@]}" -np 3 "$fake" kettle
expect_exit 2
check 'one complaint' test "$(grep -c 'found "kettle"' "$scratch/stderr")" = 1
run env SIGHTLINE_FAKE_FAILURE=1 "${mpi[@]}" -np 3 "$fake" "${job[@]}"
expect_exit 1
expect_says ': the source has failed'
expect_file a.exr.checkpoint

# A run of some forty seconds that is ended when it has written a checkpoint: DESCRIPTION FUNCTION, which is given the process of mpirun.
end_early() {
  local process
  rm -rf -- "$work" && mkdir -p "$work"
  ran="${job[*]} by 3 ranks, $1"
  (
    cd -- "$work"
    SIGHTLINE_FAKE_DELAY=300 "${mpi[@]:2}" -np 3 "$fake" "${job[@]}" --checkpoint 0.5 >"$scratch/stdout" 2>"$scratch/stderr" </dev/null &
    process=$!
    while [ ! -e a.exr.checkpoint ] && kill -0 "$process" 2>/dev/null; do sleep 0.1; done
    "$2" "$process"
    wait "$process"
  ) && status=0 || status=$?
  check 'a failure' test "$status" != 0
  expect_file a.exr.checkpoint
  run_again "${mpi[@]}" -np 2 "$fake" "${job[@]}" --resume
  expect_exit 0
  is_whole
}
ranks_of() { pgrep -P "$1"; } # of an mpirun, in the order of ranks
# shellcheck disable=SC2317 # called by end_early
end_mpirun() { kill -TERM "$1"; }
# shellcheck disable=SC2317
kill_first() { kill -KILL "$(ranks_of "$1" | head -n 1)"; }
# shellcheck disable=SC2317
kill_last() { kill -KILL "$(ranks_of "$1" | tail -n 1)"; }
end_early 'mpirun ended' end_mpirun
end_early 'rank 0 killed' kill_first
end_early 'rank 2 killed' kill_last
run_again "$programs/fake_render" "${job[@]}" --quiet
is_whole

finish
