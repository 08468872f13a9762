#pragma once

#include <gtest/gtest.h>

#include <string>

#include "pbrt/rewrite/rewrite.h"

namespace pbrt::test {

struct Rewritten {
    std::string text;      ///< empty after an error
    std::string messages;  ///< a line each
};
inline Rewritten Rewrite(const std::string &text, rewrite::Task task,
                         const std::string &dir = ".") {
    Diagnostics log;
    Rewritten r;
    r.text = rewrite::RewriteText(text, "test.pbrt", dir, task, log);
    for (const Message &m : log.Messages())
        r.messages += m.text + '\n';
    return r;
}

/// The formatted text, of which there must be no message.
inline std::string Formatted(const std::string &text) {
    const Rewritten r = Rewrite(text, rewrite::Task::Format);
    EXPECT_EQ(r.messages, "");
    return r.text;
}

}  // namespace pbrt::test
