# Completion of geodesic-bench for fish. words.sh gives the words.
set -g __geodesic_bench_words (status dirname)/words.sh
test -x $__geodesic_bench_words
or set -g __geodesic_bench_words (status dirname)/../../geodesic-bench/completion/words.sh

function __geodesic_bench
    set -l typed (commandline -opc)
    $__geodesic_bench_words $typed[1] "$typed[2]" $typed[-1]
end
complete -c geodesic-bench -a '(__geodesic_bench)'
