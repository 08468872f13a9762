# Checks the includes of all rooms of src/pbrt against the order that its CMakeLists.txt files
# declare. Reads these and all .h and .cpp files, named from within src/pbrt, in any order, and
# prints a line "file:line: rule" for each violation; the exit code is 1 if there is any.
#
# 1. A room's folder stands in src/pbrt/CMakeLists.txt, and its DEPS are rooms listed above it.
# 2. A room includes only itself and rooms that it declares in DEPS, directly or through them.
# 3. A room includes something of each of its DEPS.
# 4. An integrator, a subfolder of integrators/, includes no other one.
# 5. Embree is named in accel/ only, comments apart.
# 6. feather and simd include themselves, simd and the standard library only, without any include
#    path: "sibling.h", "../simd/file.h".
# 7. Every other include in quotes is "pbrt/<room>/<file>.h", so that rule 2 sees it.

function complain(where, rule) {
    print where ": " rule
    wrong = 1
}

function room_of(name) {
    sub(/\/.*/, "", name)
    return name
}

# Enters the rooms that `text` names as pbrt_<room> into the DEPS of `room`.
function note_deps(room, text,    words, n, i) {
    n = split(text, words, /[ ()]+/)
    for (i = 1; i <= n; ++i)
        if (words[i] ~ /^pbrt_[a-z0-9]+$/ && !((room, substr(words[i], 6)) in declared)) {
            declared[room, substr(words[i], 6)] = FILENAME ":" FNR
            deps[room] = deps[room] " " substr(words[i], 6)
        }
}

FNR == 1 {
    sub(/^\.\//, "", FILENAME)
    in_call = 0
}

FILENAME == "CMakeLists.txt" {
    if ($0 ~ /^add_subdirectory\(/) {
        name = $0
        gsub(/^add_subdirectory\(|\).*/, "", name)
        place[name] = ++rooms
        order[rooms] = name
    }
    next
}

# pbrt_room(<name> DEPS ...), and what the programs of cmd/ link.
FILENAME ~ /\/CMakeLists.txt$/ {
    sub(/#.*/, "")
    if ($0 ~ /(pbrt_room|target_link_libraries)\(/) in_call = 1
    if (in_call) {
        text = $0
        sub(/.*(pbrt_room|target_link_libraries)\([^ )]*/, "", text)
        note_deps(room_of(FILENAME), text)
    }
    if ($0 ~ /\)/) in_call = 0
    next
}

{
    code = $0
    sub(/\/\/.*/, "", code)
    if (code ~ /[Ee]mbree|EMBREE|(^|[^A-Za-z0-9_])(rtc[A-Z]|RTC[A-Z_])/ && room_of(FILENAME) != "accel")
        complain(FILENAME ":" FNR, "names Embree, which accel/ alone may")
    if (code !~ /^[ \t]*#[ \t]*include/) next
    check_include(code)
}

function check_include(code,    room, name, target, from, to) {
    room = room_of(FILENAME)
    name = code
    sub(/^[ \t]*#[ \t]*include[ \t]*/, "", name)
    sub(/[ \t]+$/, "", name)
    if (room == "feather" || room == "simd") {
        if (name !~ /^<([a-z_0-9]+|immintrin\.h|arm_neon\.h)>$/ &&
            name !~ /^"(\.\.\/simd\/)?[a-z_0-9]+\.h"$/)
            complain(FILENAME ":" FNR, room " includes " name ", but only itself, simd and the " \
                     "standard library are allowed")
        return
    }
    if (name !~ /^["<]pbrt\//) {
        if (name ~ /^"/)
            complain(FILENAME ":" FNR, name " in quotes is not of the form \"pbrt/<room>/<file>.h\"")
        return
    }
    target = name
    gsub(/^["<]pbrt\/|[">]$/, "", target)
    if (room_of(target) != room) {
        count++
        used_at[count] = FILENAME ":" FNR
        user[count] = room
        program[count] = FILENAME
        used[count] = room_of(target)
        return
    }
    if (room != "integrators") return
    from = FILENAME
    to = target
    sub(/^integrators\//, "", from)
    sub(/^integrators\//, "", to)
    if (from ~ /\// && to ~ /\// && room_of(from) != room_of(to))
        complain(FILENAME ":" FNR, "integrator " room_of(from) " includes another, " room_of(to))
}

# Enters into `reach` all rooms that `room` may include, down to the bottom.
function reach_from(room, below,    words, n, i) {
    n = split(deps[below], words, " ")
    for (i = 1; i <= n; ++i)
        if (!((room, words[i]) in reach)) {
            reach[room, words[i]] = 1
            reach_from(room, words[i])
        }
}

function base_name(path) {
    gsub(/.*\/|\.[a-z]+$/, "", path)
    return path
}

# A program of cmd/ is linked with the room of its name without more words.
function may_include(i) {
    return (user[i], used[i]) in reach ||
           user[i] == "cmd" && base_name(program[i]) == used[i]
}

END {
    for (i = 1; i <= rooms; ++i)
        reach_from(order[i], order[i])
    for (i = 1; i <= count; ++i) {
        uses[user[i], used[i]] = 1
        if (!(user[i] in place))
            complain(used_at[i], "room " user[i] " is not listed in CMakeLists.txt")
        else if (!(used[i] in place))
            complain(used_at[i], "there is no room " used[i] " in CMakeLists.txt")
        else if (place[used[i]] > place[user[i]])
            complain(used_at[i], user[i] " includes " used[i] ", which CMakeLists.txt lists later")
        else if (!may_include(i))
            complain(used_at[i], user[i] " includes " used[i] ", which its DEPS do not declare")
    }
    for (pair in declared) {
        split(pair, names, SUBSEP)
        if (!(names[2] in place)) continue  # pbrt_options
        if (place[names[2]] >= place[names[1]])
            complain(declared[pair], names[1] " declares " names[2] ", which is not listed before it")
        else if (!(pair in uses))
            complain(declared[pair], names[1] " declares " names[2] " and includes nothing of it")
    }
    exit wrong
}
