#compdef tribos
_tribos() {
    local answer value
    local -a open closed
    for answer in "${(@f)$(
        _CLAP_IFS=$'\n' _CLAP_COMPLETE_INDEX=$((CURRENT - 1)) VARIABLE=zsh \
            tribos -- "${words[@]}" 2>/dev/null
    )}"; do
        [[ -z $answer ]] && continue
        value=${answer//\\:/$'\1'}
        value=${value%%:*}
        if [[ $value == *[=/$'\1'] ]]; then
            open+=("$answer")
        else
            closed+=("$answer")
        fi
    done
    [[ -n $open ]] && _describe -V values open -S ''
    [[ -n $closed ]] && _describe -V values closed
}
if [[ $funcstack[1] == _tribos ]]; then
    _tribos "$@"
else
    compdef _tribos tribos
fi
