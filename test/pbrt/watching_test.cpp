// Watching a render while it goes on.

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <bit>
#include <cstring>
#include <map>
#include <regex>
#include <thread>

#include "pbrt/program.h"

namespace pbrt::test {
namespace {

/// Stands for tev: takes one connection and keeps the pictures that packets describe.
class Viewer {
  public:
    struct Picture {
        int width = 0, height = 0;
        std::map<std::string, std::vector<float>> channels;
        int updates = 0;
    };

    Viewer() {
        listener = socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        EXPECT_EQ(bind(listener, reinterpret_cast<sockaddr *>(&address), size), 0);
        EXPECT_EQ(listen(listener, 1), 0);
        getsockname(listener, reinterpret_cast<sockaddr *>(&address), &size);
        port = ntohs(address.sin_port);
    }
    ~Viewer() { close(listener); }
    std::string Address() const { return "127.0.0.1:" + std::to_string(port); }

    /// Takes all that is sent by one program; to be called by a thread. After `most` bytes it goes
    /// away.
    void Serve(size_t most = size_t(-1)) {
        pollfd waiting{listener, POLLIN, 0};
        if (poll(&waiting, 1, 20000) <= 0) return;
        const int fd = accept(listener, nullptr, nullptr);
        std::string bytes;
        char buffer[65536];
        size_t total = 0;
        while (total < most) {
            const ssize_t n = read(fd, buffer, sizeof buffer);
            if (n <= 0) break;
            total += size_t(n);
            bytes.append(buffer, size_t(n));
            Decode(&bytes);
        }
        close(fd);
        leftOver = bytes.size();
    }

    std::map<std::string, Picture> pictures;
    size_t leftOver = 0;
    int unknown = 0;

  private:
    /// Fields of a packet.
    struct Reader {
        std::string_view rest;
        int32_t Int() {
            uint32_t x = 0;
            for (size_t i = 0; i < 4; ++i)
                x |= uint32_t(static_cast<unsigned char>(rest[i])) << (8 * i);
            rest.remove_prefix(4);
            return int32_t(x);
        }
        float Float() { return std::bit_cast<float>(Int()); }
        std::string Text() {
            std::string text(rest.substr(0, rest.find('\0')));
            rest.remove_prefix(text.size() + 1);
            return text;
        }
        int Byte() {
            const char c = rest[0];
            rest.remove_prefix(1);
            return c;
        }
    };

    void Decode(std::string *bytes) {
        while (bytes->size() >= 4) {
            const auto length = size_t(Reader{*bytes}.Int());
            if (bytes->size() < length) return;
            Reader r{std::string_view(*bytes).substr(4, length - 4)};
            const int kind = r.Byte();
            r.Byte();  // focus
            Picture &picture = pictures[r.Text()];
            if (kind == 4)
                Create(&picture, &r);
            else if (kind == 3)
                Update(&picture, &r);
            else
                ++unknown;
            EXPECT_TRUE(r.rest.empty());
            bytes->erase(0, length);
        }
    }
    static void Create(Picture *p, Reader *r) {
        p->width = r->Int();
        p->height = r->Int();
        for (int n = r->Int(); n > 0; --n)
            p->channels[r->Text()].resize(size_t(p->width * p->height));
    }
    static void Update(Picture *p, Reader *r) {
        const std::string channel = r->Text();
        ASSERT_TRUE(p->channels.count(channel)) << channel;
        const int x0 = r->Int(), y0 = r->Int(), w = r->Int(), h = r->Int();
        ASSERT_TRUE(x0 >= 0 && y0 >= 0 && x0 + w <= p->width && y0 + h <= p->height);
        for (int y = y0; y < y0 + h; ++y)
            for (int x = x0; x < x0 + w; ++x)
                p->channels[channel][size_t(y * p->width + x)] = r->Float();
        ++p->updates;
    }

    int listener = -1, port = 0;
};

class Watching : public ProgramFolder {};

TEST_F(Watching, AViewerHasThePictureInTheEnd) {
    PutBall("\"rgb\" \"bool savefp16\" false");
    for (const std::string &crop : {std::string(), std::string("--pixelbounds 5,33,7,20 ")}) {
        Viewer viewer;
        std::thread serving([&] { viewer.Serve(); });
        Succeed("pbrt ball.pbrt --spp 1024 --outfile out.exr " + crop + "--display-server " +
                viewer.Address());
        serving.join();
        EXPECT_EQ(viewer.leftOver, 0u);
        EXPECT_EQ(viewer.unknown, 0);
        ASSERT_EQ(viewer.pictures.count("out.exr"), 1u);
        Viewer::Picture &seen = viewer.pictures["out.exr"];
        const Image image = Load("out.exr");
        ASSERT_EQ(image.Resolution(), (Point2i{seen.width, seen.height}));
        for (int c = 0; c < 3; ++c)
            for (int y = 0; y < seen.height; ++y)
                for (int x = 0; x < seen.width; ++x)
                    ASSERT_EQ(
                        image.Get({x, y}, c),
                        seen.channels[image.ChannelNames()[size_t(c)]][size_t(y * seen.width + x)]);
        EXPECT_GE(seen.updates, 3 * 6) << "each of 6 tiles once at least";
    }
}

TEST_F(Watching, AViewerThatIsNotThereOrLeavesCostsNoPicture) {
    PutBall("\"rgb\"");
    std::string address;
    {
        Viewer gone;
        address = gone.Address();
    }
    EXPECT_NE(Succeed("pbrt ball.pbrt --outfile a.exr --display-server " + address)
                  .find("Warning: --display-server " + address +
                        ": Connection refused; the viewer (tev) must run first"),
              std::string::npos);
    EXPECT_TRUE(IsThere("a.exr"));
    EXPECT_NE(Succeed("pbrt ball.pbrt --outfile a.exr --display-server nobody:x")
                  .find("--display-server: expected host:port, found nobody:x"),
              std::string::npos);
    Viewer viewer;
    std::thread serving([&] { viewer.Serve(1); });
    Succeed("pbrt ball.pbrt --spp 2048 --outfile b.exr --display-server " + viewer.Address());
    serving.join();
    EXPECT_TRUE(IsThere("b.exr"));
}

TEST_F(Watching, PartialImagesAreWritten) {
    PutBall("\"rgb\"");
    Succeed("pbrt --quiet ball.pbrt --outfile right.exr");
    // The picture of a render that is stopped is its last partial one.
    const Outcome stopped =
        Run("timeout --preserve-status -s TERM 1 pbrt ball.pbrt --spp 100000 --outfile out.exr "
            "--write-partial-images");
    EXPECT_EQ(stopped.exitCode, 143) << stopped.said;
    const Image partial = Load("out.exr");
    const int spp = partial.metadata.samplesPerPixel.value_or(0);
    EXPECT_TRUE(spp == 1 || spp == 4 || spp == 16 || spp == 32 || spp % 64 == 0) << spp;
    Succeed("pbrt --quiet ball.pbrt --outfile out.exr --write-partial-images");
    EXPECT_TRUE(Get("out.exr") == Get("right.exr"));
}

TEST_F(Watching, TheLastLineSaysWhatWasWritten) {
    PutBall("\"rgb\"");
    const std::string said = Succeed("pbrt ball.pbrt --outfile out.exr");
    EXPECT_TRUE(std::regex_search(
        said, std::regex("\nwrote out\\.exr \\([0-9.]+ [kKM]B, 128 spp, [0-9.]+ m?s\\)\n$")))
        << said;
    EXPECT_EQ(Succeed("pbrt ball.pbrt --outfile out.exr --quiet"), "");
}

/// On a terminal: stages, per cent, samples, rays, time left.
TEST_F(Watching, ATerminalShowsProgress) {
    PutBall("\"rgb\"");
    const std::string said =
        Succeed("script -qec 'pbrt ball.pbrt --spp 4096 --outfile out.exr' /dev/null < /dev/null");
    EXPECT_NE(said.find("Parsing: "), std::string::npos) << said;
    EXPECT_NE(said.find("Building: "), std::string::npos) << said;
    EXPECT_TRUE(std::regex_search(
        said, std::regex("Rendering: .*[0-9]+% [0-9.]+/4096 spp, [0-9.]+ Mrays/s, [0-9.]+ s, "
                         "[0-9.]+ (s|min [0-9]+ s) left")))
        << said;
}

TEST_F(Watching, PixelStatsAreAPicture) {
    PutBall("\"rgb\"");
    Succeed("pbrt --quiet ball.pbrt --pixelstats --outfile out.exr");
    const Image stats = Load("out-stats.exr");
    EXPECT_EQ(stats.ChannelNames(), (std::vector<std::string>{"rays", "samples", "seconds"}));
    for (size_t i = 0; i < stats.Data().size(); i += 3) {
        EXPECT_GE(stats.Data()[i], 128);  // one of each sample at least
        EXPECT_EQ(stats.Data()[i + 1], 128);
        EXPECT_GT(stats.Data()[i + 2], 0);
    }
}

}  // namespace
}  // namespace pbrt::test
