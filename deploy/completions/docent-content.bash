# bash completion for docent-content; made of its table of options by tests/deploy.
_docent_offer() {
  [[ $1 == -W ]] || compopt -o filenames
  mapfile -t COMPREPLY < <(compgen "$@" -- "$word")
}
_docent_content() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} path=docent-content i
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; i++)); do
    case "$path ${COMP_WORDS[i]}" in
    'docent-content compile' | 'docent-content check' | 'docent-content import' | 'docent-content translate' | 'docent-content info' | 'docent-content schema' | 'docent-content route' | 'docent-content tour' | 'docent-content at' | 'docent-content see' | 'docent-content near' | 'docent-content offset' | 'docent-content show' | 'docent-content graph' | 'docent-content figure' | 'docent-content walk' | 'docent-content film' | 'docent-content keygen' | 'docent-content sign' | 'docent-content verify' | 'docent-content release') path+=" ${COMP_WORDS[i]}" ;;
    esac
  done
  case "$path $before" in
    'docent-content compile -o' | 'docent-content compile --output') _docent_offer -f; return ;;
    'docent-content compile --clips') _docent_offer -d; return ;;
    'docent-content compile --coordinates') _docent_offer -W 'metres wgs84'; return ;;
    'docent-content compile --radius') :; return ;;
    'docent-content compile --jobs') :; return ;;
    'docent-content check --clips') _docent_offer -d; return ;;
    'docent-content check --coordinates') _docent_offer -W 'metres wgs84'; return ;;
    'docent-content check --radius') :; return ;;
    'docent-content check --jobs') :; return ;;
    'docent-content import -o' | 'docent-content import --output') _docent_offer -d; return ;;
    'docent-content import --unit') :; return ;;
    'docent-content import --origin') :; return ;;
    'docent-content import --level') :; return ;;
    'docent-content import --layers') :; return ;;
    'docent-content translate --out') _docent_offer -f; return ;;
    'docent-content translate --in') _docent_offer -f; return ;;
    'docent-content translate --from') :; return ;;
    'docent-content translate --to') :; return ;;
    'docent-content route --kind') _docent_offer -W 'shortest skeleton offset'; return ;;
    'docent-content route --from') :; return ;;
    'docent-content route --to') :; return ;;
    'docent-content route --to-place') _docent_offer -W 'toilets accessible_toilets all_gender_toilets womens_toilets mens_toilets baby_change exit emergency_exit entrance information tickets cloakroom lockers cafe restaurant shop lift stairs seat water first_aid defibrillator quiet_room prayer_room meeting_point lost_and_found cash_machine telephone library auditorium parking'; return ;;
    'docent-content route --exhibits') :; return ;;
    'docent-content route --radius') :; return ;;
    'docent-content route --offset') :; return ;;
    'docent-content route --hand') _docent_offer -W 'left right'; return ;;
    'docent-content route --floor') :; return ;;
    'docent-content route --from-floor') :; return ;;
    'docent-content route --to-floor') :; return ;;
    'docent-content route --metric') _docent_offer -W 'time length'; return ;;
    'docent-content route --at') :; return ;;
    'docent-content route --today') _docent_offer -f; return ;;
    'docent-content route --svg') _docent_offer -f; return ;;
    'docent-content route --queries') _docent_offer -f; return ;;
    'docent-content route -o' | 'docent-content route --output') _docent_offer -f; return ;;
    'docent-content route --repeat') :; return ;;
    'docent-content tour --exhibits') :; return ;;
    'docent-content tour --first') :; return ;;
    'docent-content tour --last') :; return ;;
    'docent-content tour --minutes') :; return ;;
    'docent-content at --points') _docent_offer -f; return ;;
    'docent-content at -o' | 'docent-content at --output') _docent_offer -f; return ;;
    'docent-content at --floor') :; return ;;
    'docent-content see --pairs') _docent_offer -f; return ;;
    'docent-content see -o' | 'docent-content see --output') _docent_offer -f; return ;;
    'docent-content see --floor') :; return ;;
    'docent-content near --from') :; return ;;
    'docent-content near --exhibit') :; return ;;
    'docent-content near --within') :; return ;;
    'docent-content near --speed') :; return ;;
    'docent-content near --radius') :; return ;;
    'docent-content near --floor') :; return ;;
    'docent-content offset --distance') :; return ;;
    'docent-content offset --floor') :; return ;;
    'docent-content offset --svg') _docent_offer -f; return ;;
    'docent-content show -o' | 'docent-content show --output') _docent_offer -f; return ;;
    'docent-content show --layers') :; return ;;
    'docent-content show --floor') :; return ;;
    'docent-content graph -o' | 'docent-content graph --output') _docent_offer -f; return ;;
    'docent-content figure -o' | 'docent-content figure --output') _docent_offer -f; return ;;
    'docent-content walk --path') _docent_offer -f; return ;;
    'docent-content walk -o' | 'docent-content walk --output') _docent_offer -f; return ;;
    'docent-content walk --search') _docent_offer -W 'docent paper'; return ;;
    'docent-content walk --lookahead') :; return ;;
    'docent-content walk --use-rate') :; return ;;
    'docent-content walk --time-limit') :; return ;;
    'docent-content walk --start') :; return ;;
    'docent-content walk --fps') :; return ;;
    'docent-content film --path') _docent_offer -f; return ;;
    'docent-content film -o' | 'docent-content film --output') _docent_offer -f; return ;;
    'docent-content film --view') _docent_offer -W 'front side back above kiosk'; return ;;
    'docent-content film --look') _docent_offer -W 'teal vermilion saffron navy sky rose ivory plum stone sand slate clay'; return ;;
    'docent-content film --at') :; return ;;
    'docent-content film --frames') :; return ;;
    'docent-content film --floor') :; return ;;
    'docent-content keygen -o' | 'docent-content keygen --output') _docent_offer -f; return ;;
    'docent-content sign --key') _docent_offer -f; return ;;
    'docent-content verify --key') _docent_offer -f; return ;;
    'docent-content release -o' | 'docent-content release --output') _docent_offer -d; return ;;
    'docent-content release --key') _docent_offer -f; return ;;
    'docent-content release --release') :; return ;;
    'docent-content release --expires') :; return ;;
    'docent-content release --group') :; return ;;
    'docent-content release --rollout') :; return ;;
    'docent-content release --halt') :; return ;;
    'docent-content release --program') :; return ;;
  esac
  case "$path" in
    'docent-content') if [[ $word == -* ]]; then _docent_offer -W '-h --help --version'; else _docent_offer -W 'compile check import translate info schema route tour at see near offset show graph figure walk film keygen sign verify release'; fi ;;
    'docent-content compile') if [[ $word == -* ]]; then _docent_offer -W '-o --output --clips --coordinates --radius --no-motion --speech --no-speech --mirrored --no-mirrored --turns --no-turns --jobs --json --quiet -h --help'; else _docent_offer -f; fi ;;
    'docent-content check') if [[ $word == -* ]]; then _docent_offer -W '--clips --coordinates --radius --no-motion --speech --no-speech --mirrored --no-mirrored --turns --no-turns --jobs --json --quiet -h --help'; else _docent_offer -f; fi ;;
    'docent-content import') if [[ $word == -* ]]; then _docent_offer -W '-o --output --unit --origin --level --layers --json -h --help'; else _docent_offer -f; fi ;;
    'docent-content translate') if [[ $word == -* ]]; then _docent_offer -W '--out --in --from --to -h --help'; else _docent_offer -d; fi ;;
    'docent-content info') if [[ $word == -* ]]; then _docent_offer -W '--json -h --help'; else _docent_offer -f; fi ;;
    'docent-content schema') if [[ $word == -* ]]; then _docent_offer -W '-h --help'; else :; fi ;;
    'docent-content route') if [[ $word == -* ]]; then _docent_offer -W '--kind --from --to --to-place --exhibits --radius --offset --hand --widest --smooth --floor --from-floor --to-floor --metric --step-free --no-escalators --at --today --json --svg --queries -o --output --repeat -h --help'; else _docent_offer -f; fi ;;
    'docent-content tour') if [[ $word == -* ]]; then _docent_offer -W '--exhibits --first --last --minutes --step-free --json -h --help'; else _docent_offer -f; fi ;;
    'docent-content at') if [[ $word == -* ]]; then _docent_offer -W '--points -o --output --floor -h --help'; else _docent_offer -f; fi ;;
    'docent-content see') if [[ $word == -* ]]; then _docent_offer -W '--pairs -o --output --floor -h --help'; else _docent_offer -f; fi ;;
    'docent-content near') if [[ $word == -* ]]; then _docent_offer -W '--from --exhibit --within --speed --radius --floor --json -h --help'; else _docent_offer -f; fi ;;
    'docent-content offset') if [[ $word == -* ]]; then _docent_offer -W '--distance --floor --json --svg -h --help'; else _docent_offer -f; fi ;;
    'docent-content show') if [[ $word == -* ]]; then _docent_offer -W '-o --output --layers --floor -h --help'; else _docent_offer -f; fi ;;
    'docent-content graph') if [[ $word == -* ]]; then _docent_offer -W '-o --output --json -h --help'; else _docent_offer -f; fi ;;
    'docent-content figure') if [[ $word == -* ]]; then _docent_offer -W '-o --output --json -h --help'; else _docent_offer -f; fi ;;
    'docent-content walk') if [[ $word == -* ]]; then _docent_offer -W '--path -o --output --search --lookahead --use-rate --time-limit --start --fps --exact --raw --json -h --help'; else _docent_offer -f; fi ;;
    'docent-content film') if [[ $word == -* ]]; then _docent_offer -W '--path -o --output --view --look --at --frames --floor -h --help'; else _docent_offer -f; fi ;;
    'docent-content keygen') if [[ $word == -* ]]; then _docent_offer -W '-o --output -h --help'; else :; fi ;;
    'docent-content sign') if [[ $word == -* ]]; then _docent_offer -W '--key -h --help'; else _docent_offer -f; fi ;;
    'docent-content verify') if [[ $word == -* ]]; then _docent_offer -W '--key -h --help'; else _docent_offer -f; fi ;;
    'docent-content release') if [[ $word == -* ]]; then _docent_offer -W '-o --output --key --release --expires --group --rollout --halt --program -h --help'; else _docent_offer -f; fi ;;
  esac
}
complete -F _docent_content docent-content
