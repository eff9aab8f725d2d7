# Reads a compile_commands.json as CMake writes it (a key a line) and writes one of fewer units: each includes up to `most` of those, no two
# of one room, whose files may use a name twice, and no two that begin a program. Units go to FOLDER/together_N.cpp, the list to FOLDER/compile_commands.json.
# awk -v top=SOURCES -v build=BUILD -v folder=FOLDER -v most=10 -f together.awk BUILD/compile_commands.json
function room_of(file, part) {
  if (file ~ /\/main\.cpp$/) return "main"
  sub("^" build "/", "", file)
  sub("^" top "/", "", file)
  split(file, part, "/")
  return part[1] "/" part[2]
}
function take(file, command, room, n, i, count, word, flag) {
  if (file ~ /common\.cpp$/) return
  room = room_of(file)
  for (n = 0; n < groups && (size[n] >= most || (n, room) in is_in); ++n) {}
  if (n == groups) ++groups
  ++size[n]
  is_in[n, room] = 1
  files[n] = files[n] "#include \"" file "\"\n"
  sub(/^.*clang\+\+-19 /, "", command)
  count = split(command, word, " ")
  for (i = 1; i <= count; ++i) {
    if (word[i] == "-o" || word[i] == "-c") { ++i; continue }
    flag = word[i]
    if (flag == "-isystem") flag = flag " " word[++i]
    if ((n, flag) in has) continue
    has[n, flag] = 1
    flags[n] = flags[n] " " flag
  }
}
/^ *"command": "/ { command = $0; sub(/^ *"command": "/, "", command); sub(/",?$/, "", command) }
/^ *"file": "/ { file = $0; sub(/^ *"file": "/, "", file); sub(/",?$/, "", file) }
/^ *}/ { take(file, command) }
END {
  list = folder "/compile_commands.json"
  printf "[" > list
  for (n = 0; n < groups; ++n) {
    name = folder "/together_" n ".cpp"
    printf "%s", files[n] > name
    printf "%s\n{\n  \"directory\": \"%s\",\n  \"command\": \"clang++-19%s -o /dev/null -c %s\",\n  \"file\": \"%s\"\n}", n ? "," : "", build, flags[n], name, name > list
  }
  print "\n]" > list
}
