# bash completion for docent-update; made of its table of options by tests/deploy.
_docent_offer() {
  [[ $1 == -W ]] || compopt -o filenames
  mapfile -t COMPREPLY < <(compgen "$@" -- "$word")
}
_docent_update() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} path=docent-update i
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; i++)); do
    case "$path ${COMP_WORDS[i]}" in
    ) path+=" ${COMP_WORDS[i]}" ;;
    esac
  done
  case "$path $before" in
    'docent-update --source') _docent_offer -d; return ;;
    'docent-update --config') _docent_offer -f; return ;;
  esac
  case "$path" in
    'docent-update') if [[ $word == -* ]]; then _docent_offer -W '--source --config --once --back --starting --json -h --help --version'; else :; fi ;;
  esac
}
complete -F _docent_update docent-update
