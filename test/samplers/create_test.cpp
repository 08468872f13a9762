#include <gtest/gtest.h>

#include "pbrt/samplers/samplers.h"

namespace pbrt {
namespace {

ParsedParameter Integer(std::string name, int value) {
    ParsedParameter p;
    p.type = "integer", p.name = std::move(name), p.ints = {value};
    return p;
}
ParsedParameter String(std::string name, std::string value) {
    ParsedParameter p;
    p.type = "string", p.name = std::move(name), p.strings = {std::move(value)};
    return p;
}

struct Created {
    std::optional<Sampler> sampler;
    Diagnostics log;
};

Created Create(std::string_view type, ParsedParameters params = {}, std::optional<int> spp = {},
               int seed = 0) {
    Created created;
    ParamDict dict(std::move(params), {"scene.pbrt", 3, 1}, "sampler", nullptr, &created.log);
    created.sampler = CreateSampler(dict, type, spp, seed, {64, 64});
    return created;
}

int SamplesPerPixel(const Created &c) {
    return std::visit([](const auto &s) { return s.SamplesPerPixel(); }, c.sampler.value());
}

float FirstNumber(const Created &c) {
    return std::visit(
        [](auto s) {
            s.StartPixelSample({1, 2}, 0);
            return s.Get1D();
        },
        c.sampler.value());
}

TEST(CreateSampler, PbrtsDefaults) {
    EXPECT_EQ(SamplesPerPixel(Create("independent")), 4);
    EXPECT_EQ(SamplesPerPixel(Create("stratified")), 16);
    for (const char *type : {"zsobol", "halton", "sobol", "paddedsobol", "pmj02bn"})
        EXPECT_EQ(SamplesPerPixel(Create(type)), 16) << type;
}

TEST(CreateSampler, CommandLineSppComesFirst) {
    EXPECT_EQ(SamplesPerPixel(Create("independent", {Integer("pixelsamples", 9)}, 7)), 7);
    EXPECT_EQ(SamplesPerPixel(Create("zsobol", {Integer("pixelsamples", 8)}, 32)), 32);
    for (int spp : {1, 7, 12, 16, 30})
        EXPECT_EQ(SamplesPerPixel(Create("stratified", {}, spp)), spp);
}

TEST(CreateSampler, SeedOfTheFileComesFirst) {
    for (const char *type :
         {"independent", "stratified", "zsobol", "halton", "sobol", "paddedsobol", "pmj02bn"}) {
        const float def = FirstNumber(Create(type));
        EXPECT_NE(FirstNumber(Create(type, {}, {}, 5)), def);
        EXPECT_EQ(FirstNumber(Create(type, {Integer("seed", 5)})),
                  FirstNumber(Create(type, {}, {}, 5)));
        EXPECT_EQ(FirstNumber(Create(type, {Integer("seed", 0)}, {}, 5)), def);
    }
}

TEST(CreateSampler, ZSobolWarnsOfTruncation) {
    const Created created = Create("zsobol", {Integer("pixelsamples", 100)});
    EXPECT_EQ(SamplesPerPixel(created), 64);
    ASSERT_EQ(created.log.Messages().size(), 1u);
    EXPECT_EQ(created.log.Messages()[0].severity, Severity::Warning);
    EXPECT_NE(created.log.Messages()[0].text.find("64 samples per pixel instead of 100"),
              std::string::npos);
}

/// Other numbers of samples than the best are taken as they are.
TEST(CreateSampler, OthersAdviseAgainstOddNumbersOfSamples) {
    const auto advice = [](const char *type, int samples) {
        const Created created = Create(type, {Integer("pixelsamples", samples)});
        EXPECT_EQ(SamplesPerPixel(created), samples);
        EXPECT_FALSE(created.log.HasErrors());
        return created.log.Messages().empty() ? "" : created.log.Messages()[0].text;
    };
    for (const char *type : {"sobol", "paddedsobol"}) {
        EXPECT_EQ(advice(type, 32), "");
        EXPECT_NE(advice(type, 100).find("a power of two, which 100 is not"), std::string::npos);
    }
    EXPECT_EQ(advice("pmj02bn", 64), "");
    EXPECT_NE(advice("pmj02bn", 32).find("a power of four, which 32 is not"), std::string::npos);
    EXPECT_EQ(advice("halton", 100), "");
    EXPECT_EQ(SamplesPerPixel(Create("sobol", {}, 1)), 1);
}

TEST(CreateSampler, SamplesBeyondALimitAreErrors) {
    for (const char *type : {"halton", "pmj02bn"}) {
        EXPECT_FALSE(Create(type, {Integer("pixelsamples", 65536)}).log.HasErrors());
        EXPECT_TRUE(Create(type, {Integer("pixelsamples", 65537)}).log.HasErrors());
        EXPECT_TRUE(Create(type, {}, 65537).log.HasErrors());
    }
}

TEST(CreateSampler, EachRandomizationGivesOtherNumbers) {
    for (const char *type : {"zsobol", "sobol", "paddedsobol", "halton"}) {
        std::vector<float> numbers;
        for (const char *name : {"none", "permutedigits", "owen", "fastowen"}) {
            const Created created = Create(type, {String("randomization", name)});
            const bool known = std::string_view(type) != "halton" || numbers.size() < 3;
            EXPECT_EQ(created.log.HasErrors(), !known) << type << " " << name;
            if (!known) continue;
            for (float other : numbers)
                EXPECT_NE(FirstNumber(created), other) << type << " " << name;
            numbers.push_back(FirstNumber(created));
        }
    }
}

TEST(CreateSampler, UsersMistakesAreErrors) {
    const Created unknown = Create("zsobool");
    EXPECT_FALSE(unknown.sampler);
    ASSERT_TRUE(unknown.log.HasErrors());
    for (const char *part : {"scene.pbrt:3:1", "zsobool", "did you mean \"zsobol\"", "stratified"})
        EXPECT_NE(unknown.log.Messages()[0].text.find(part), std::string::npos) << part;
    EXPECT_TRUE(Create("zsobol", {Integer("pixelsamples", 0)}).log.HasErrors());
    EXPECT_TRUE(Create("zsobol", {String("randomization", "slow")}).log.HasErrors());
    EXPECT_TRUE(Create("independent", {Integer("xsamples", 4)}).log.HasErrors());
}

}  // namespace
}  // namespace pbrt
