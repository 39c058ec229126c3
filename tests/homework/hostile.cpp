// A program that does one bad thing: argv[1] says which. argv[2] is a file or folder where that needs one.
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <thread>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

using namespace std::chrono_literals;

/// Memory that is really there, and stays.
char* take(std::size_t bytes)
{
    char* memory = static_cast<char*>(std::malloc(bytes));
    if (memory) std::memset(memory, 1, bytes);
    return memory;
}

/// A process that no parent and no signal to a group reaches.
void becomeADaemon()
{
    if (::fork() != 0) return;
    ::setsid();
    if (::fork() != 0) ::_exit(0);
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) ::signal(signal, SIG_IGN);
    while (true) std::this_thread::sleep_for(1s);
}

int connectTo(int port)
{
    const int   socket = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family      = AF_INET;
    address.sin_port        = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return ::connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0 ? 0 : 3;
}

int run(const std::string& deed, const std::string& where)
{
    if (deed == "nothing") return 0;
    if (deed == "status") return std::atoi(where.c_str());
    if (deed == "crash") std::raise(SIGSEGV);
    if (deed == "abort") std::abort();
    if (deed == "loop")
        for (std::atomic<unsigned> turn{0};; ++turn) {}
    if (deed == "memory")
        while (take(std::size_t{1} << 20)) {}
    if (deed == "memory-in-children") {  // no one of them comes near the limit
        for (int child = 0; child < 6; ++child)
            if (::fork() == 0) {
                take(std::size_t{40} << 20);
                ::pause();
            }
        ::pause();
    }
    if (deed == "memory-for-a-moment") return std::free(take(std::size_t{150} << 20)), 0;
    if (deed == "memory-shared") {  // 60 MiB that six processes look at
        take(std::size_t{60} << 20);
        for (int child = 0; child < 5; ++child)
            if (::fork() == 0) ::_exit((std::this_thread::sleep_for(300ms), 0));
        std::this_thread::sleep_for(300ms);
        return 0;
    }
    if (deed == "forks")
        while (true) ::fork();
    if (deed == "text")
        while (true) std::puts("I must not write so much.");
    if (deed == "file") {
        std::ofstream     file(where, std::ios::binary);
        const std::string block(1 << 16, 'x');
        while (true) file << block << std::flush;
    }
    if (deed == "files")
        for (int i = 0;; ++i) std::ofstream(where + "/" + std::to_string(i)) << i;
    if (deed == "locked") {  // a folder without rights that holds something
        ::mkdir((where + "/a").c_str(), 0700);
        std::ofstream(where + "/a/b") << 1;
        return ::chmod((where + "/a").c_str(), 0) == 0 ? 0 : 3;
    }
    if (deed == "daemon") return becomeADaemon(), 0;
    if (deed == "read") return std::ifstream(where).good() ? 0 : 3;
    if (deed == "write") return (std::ofstream(where) << "x").good() ? 0 : 3;
    if (deed == "connect") return connectTo(std::atoi(where.c_str()));
    return 9;
}

}  // namespace

int main(int count, char** words) { return run(count > 1 ? words[1] : "", count > 2 ? words[2] : ""); }
