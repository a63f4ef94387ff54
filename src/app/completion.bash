# bash completion for drape
_drape() {
    local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} verb=${COMP_WORDS[1]}
    local run="--out --method --step --tolerance --budget --replay --strict --no-estimate --untangle --threads --set --cache --resume --from --checkpoint-every \
--verify-hashes --quiet --help"
    COMPREPLY=()

    if ((COMP_CWORD == 1)); then
        mapfile -t COMPREPLY < <(compgen -W "render simulate inspect study stability lab compare video gallery mesh list --help --version" -- "$word")
        return
    fi
    case $previous in
        --out)
            local kind=-d
            [[ $verb == video ]] && kind=-f
            mapfile -t COMPREPLY < <(compgen "$kind" -- "$word")
            return
            ;;
        --cache | --replay | --verify-hashes | --json | --junit | --html | --video | --remesh | -o) mapfile -t COMPREPLY < <(compgen -f -- "$word") && return ;;
        --method)
            mapfile -t COMPREPLY < <(compgen -W "auto symplectic_euler verlet takahashi_imada srkn4 srkn6 rk4 \
                embedded_rk xpbd backward_euler_1 backward_euler bdf2 tr_bdf2 projective_dynamics" -- "$word")
            return
            ;;
        --over)
            mapfile -t COMPREPLY < <(compgen -W "rectangle disc annulus outline" -- "$word")
            return
            ;;
        --hole | --outline | --finer | --from | --checkpoint-every | --step | --tolerance | --threads | --set | --frames | --size | --until | --bending-length | --density | --repeats | --budget | --share | --mean | --rms | --limit | --ignore | --fps | --speed | --loop | --caption | --label | --columns | --width | --at-most | --only) return ;;
    esac

    local words
    if [[ $verb == lab && $previous == fit ]]; then
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
        return
    fi
    case $verb in
        render) words="$run --frames --size --video" ;;
        simulate) words="$run" ;;
        inspect) words="--set --help" ;;
        study) words="--out --set --until --repeats --budget --method --refine --quiet --help" ;;
        stability) words="--out --set --method --runs --threads --full --quiet --help" ;;
        lab) words="anisotropy folds density compression erratum jumps jitter fabric validation fit --out --bending-length --density --quiet --help" ;;
        compare) words="--share --mean --rms --limit --ignore --perceptual --hausdorff --html --json --junit --accept --quiet --help" ;;
        gallery) words="--out --only --quick --threads --quiet --help" ;;
        video) words="--out --fps --speed --boomerang --loop --caption --no-caption --width --at-most --side-by-side --label --columns --difference --quiet --help" ;;
        mesh) words="one_way alternating crossed equilateral pseudo_random adaptive -o --size --divisions --seed --over --hole --outline --finer --remesh --help" ;;
        list) words="scenes fabrics methods obstacles patterns membranes lab --help" ;;
        *) return ;;
    esac
    if [[ $word == -* || $verb == mesh || $verb == list || $verb == lab ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
    else
        # folders to walk through, and scenes; any file where a mesh may stand
        local pattern='*.toml'
        [[ $verb == inspect || $verb == compare ]] && pattern='*'
        [[ $verb == video ]] && pattern=
        mapfile -t COMPREPLY < <({ compgen -d -- "$word"; compgen -f -X "!$pattern" -- "$word"; } | sort -u)
    fi
}
complete -o filenames -F _drape drape
