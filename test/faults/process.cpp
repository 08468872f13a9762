#include "faults/process.h"

#include <fcntl.h>
#include <grp.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <thread>

#include "support/folders.h"

namespace pbrt::test {
namespace {

/// A user who has no other process.
constexpr uid_t kNobodyElse = 61234;
constexpr int kCannotStart = 127;

void Limit(decltype(RLIMIT_AS) which, uint64_t value) {
    const rlimit limit{value, value};
    if (setrlimit(which, &limit) != 0) _exit(kCannotStart);
}

/// In the child: all that is between fork and exec, without allocation.
void Become(const char *folder, const Limits &limits, int output) {
    if (chdir(folder) != 0) _exit(kCannotStart);
    const auto open = [output](const std::string &file) {
        return file.empty() ? output : ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    };
    const int in = ::open("/dev/null", O_RDONLY), out = open(limits.out), err = open(limits.err);
    if (in < 0 || out < 0 || err < 0) _exit(kCannotStart);
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    if (limits.ignored > 0) signal(limits.ignored, SIG_IGN);
    Limit(RLIMIT_CORE, 0);
    if (limits.addressSpace > 0) Limit(RLIMIT_AS, limits.addressSpace);
    if (limits.fileSize > 0) Limit(RLIMIT_FSIZE, limits.fileSize);
    if (limits.threads > 0) {
        Limit(RLIMIT_NPROC, uint64_t(limits.threads));
        if (geteuid() == 0 &&
            (setgroups(0, nullptr) != 0 || setgid(kNobodyElse) != 0 || setuid(kNobodyElse) != 0))
            _exit(kCannotStart);
    }
}

}  // namespace

Process::Process(const std::string &program, const std::vector<std::string> &args,
                 const std::string &folder, const Limits &limits) {
    const std::string path = program[0] == '/' ? program : ProgramDir() + "/" + program;
    std::vector<char *> words{const_cast<char *>(path.c_str())};
    for (const std::string &word : args)
        words.push_back(const_cast<char *>(word.c_str()));
    words.push_back(nullptr);
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return;
    output = ends[0];
    pid = fork();
    if (pid == 0) {
        Become(folder.c_str(), limits, ends[1]);
        execv(path.c_str(), words.data());
        _exit(kCannotStart);
    }
    close(ends[1]);
}

Process::~Process() {
    Wait(std::chrono::seconds(0));
    if (output >= 0) close(output);
}

void Process::Signal(int number) const {
    if (pid > 0) kill(pid, number);
}

bool Process::Catches(int number) const {
    using namespace std::chrono_literals;
    const std::string status = "/proc/" + std::to_string(pid) + "/status";
    for (int i = 0; i < 2000; ++i) {
        std::ifstream file(status);
        for (std::string word; file >> word;)
            if (uint64_t mask = 0; word == "SigCgt:" && file >> std::hex >> mask)
                if (mask >> (number - 1) & 1) return true;
        std::this_thread::sleep_for(10ms);
    }
    return false;
}

bool Process::Read(std::chrono::steady_clock::time_point until) {
    using std::chrono::duration_cast, std::chrono::milliseconds;
    const auto left = duration_cast<milliseconds>(until - std::chrono::steady_clock::now());
    pollfd waiting{output, POLLIN, 0};
    const int wait = int(std::clamp<int64_t>(left.count(), 0, 100));
    if (poll(&waiting, 1, wait) <= 0) return false;
    char buffer[4096];
    const ssize_t n = read(output, buffer, sizeof buffer);
    if (n > 0) outcome.said.append(buffer, size_t(n));
    return n == 0;
}

bool Process::Says(const std::string &text, std::chrono::seconds longest) {
    const auto until = std::chrono::steady_clock::now() + longest;
    bool ended = false;
    while (outcome.said.find(text) == std::string::npos) {
        if (ended || std::chrono::steady_clock::now() >= until) return false;
        ended = Read(until);
    }
    return true;
}

Outcome Process::Wait(std::chrono::seconds longest) {
    if (pid <= 0) return outcome;
    const auto until = std::chrono::steady_clock::now() + longest;
    while (!Read(until))
        if (std::chrono::steady_clock::now() >= until) {
            outcome.tooLong = true;
            kill(pid, SIGKILL);
            break;
        }
    int status = 0;
    if (waitpid(pid, &status, 0) == pid) {
        if (WIFEXITED(status)) outcome.exitCode = WEXITSTATUS(status);
        if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
    }
    pid = -1;
    return outcome;
}

bool CanLimitThreads() {
    const Outcome outcome = Process("imgtool", {"help"}, "/", {.threads = 1}).Wait();
    return outcome.exitCode == 0;
}

}  // namespace pbrt::test
