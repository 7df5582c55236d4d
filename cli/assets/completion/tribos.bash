_tribos() {
    local IFS=$'\013' words=() word glue= last
    for word in "${COMP_WORDS[@]:0:COMP_CWORD+1}"; do
        last=$((${#words[@]} - 1))
        if [[ $last -gt 0 && ( -n $glue || $word == [=:]* ) ]]; then
            words[last]+=$word
        else
            words+=("$word")
        fi
        glue=
        [[ $word == *[=:] ]] && glue=1
    done
    last=$((${#words[@]} - 1))
    COMPREPLY=( $(
        _CLAP_IFS="$IFS" _CLAP_COMPLETE_INDEX="$last" VARIABLE=bash \
            "${COMP_WORDS[0]}" -- "${words[@]}" 2>/dev/null
    ) )
    local head=${words[last]}
    if [[ $head == *[=:]* ]]; then
        word=${head##*[=:]}
        head=${head%"$word"}
        COMPREPLY=( "${COMPREPLY[@]#"$head"}" )
    fi
    if [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *[=:/] ]]; then
        compopt -o nospace 2>/dev/null
    fi
    return 0
}
complete -o bashdefault -F _tribos tribos
