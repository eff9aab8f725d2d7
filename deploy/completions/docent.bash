# bash completion for docent; made of its table of options by tests/deploy.
_docent_offer() {
  [[ $1 == -W ]] || compopt -o filenames
  mapfile -t COMPREPLY < <(compgen "$@" -- "$word")
}
_docent() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} path=docent i
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; i++)); do
    case "$path ${COMP_WORDS[i]}" in
    'docent check' | 'docent counts' | 'docent hid' | 'docent hid list' | 'docent hid decode' | 'docent pin' | 'docent status') path+=" ${COMP_WORDS[i]}" ;;
    esac
  done
  case "$path $before" in
    'docent --content') _docent_offer -f; return ;;
    'docent --config') _docent_offer -f; return ;;
    'docent --display') _docent_offer -W 'auto kms window headless'; return ;;
    'docent --size') :; return ;;
    'docent --rotate') _docent_offer -W '0 90 180 270'; return ;;
    'docent --today') _docent_offer -f; return ;;
    'docent --visit') _docent_offer -f; return ;;
    'docent --record') _docent_offer -d; return ;;
    'docent --states') _docent_offer -f; return ;;
    'docent --seconds') :; return ;;
    'docent --stats') _docent_offer -f; return ;;
    'docent --speech') _docent_offer -f; return ;;
    'docent --health') _docent_offer -f; return ;;
    'docent --counts') _docent_offer -d; return ;;
    'docent --hid') _docent_offer -f; return ;;
    'docent check --config') _docent_offer -f; return ;;
  esac
  case "$path" in
    'docent') if [[ $word == -* ]]; then _docent_offer -W '--content --config --display --size --rotate --today --visit --record --states --seconds --stats --speech --health --counts --hid -h --help --version'; else _docent_offer -W 'check counts hid pin status'; fi ;;
    'docent check') if [[ $word == -* ]]; then _docent_offer -W '--config -h --help'; else _docent_offer -f; fi ;;
    'docent counts') if [[ $word == -* ]]; then _docent_offer -W '-h --help'; else _docent_offer -d; fi ;;
    'docent hid') if [[ $word == -* ]]; then _docent_offer -W '-h --help'; else _docent_offer -W 'list decode'; fi ;;
    'docent hid list') if [[ $word == -* ]]; then _docent_offer -W '--json -h --help'; else :; fi ;;
    'docent hid decode') if [[ $word == -* ]]; then _docent_offer -W '-h --help'; else _docent_offer -f; fi ;;
    'docent pin') if [[ $word == -* ]]; then _docent_offer -W '-h --help'; else :; fi ;;
    'docent status') if [[ $word == -* ]]; then _docent_offer -W '--json -h --help'; else :; fi ;;
  esac
}
complete -F _docent docent
