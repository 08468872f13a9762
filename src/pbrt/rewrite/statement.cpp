#include "pbrt/rewrite/statement.h"

#include <algorithm>

#include "pbrt/scene/number.h"

namespace pbrt::rewrite {

Parameter *Statement::Find(std::string_view name) {
    const auto found = std::find_if(parameters.rbegin(), parameters.rend(),
                                    [&](const Parameter &p) { return p.name == name; });
    return found == parameters.rend() ? nullptr : &*found;
}

void Statement::Remove(std::string_view name) {
    for (const Parameter &p : parameters) {
        if (p.name != name) continue;
        comments.insert(comments.end(), p.comments.begin(), p.comments.end());
        if (!p.remark.empty()) comments.push_back(p.remark);
    }
    std::erase_if(parameters, [&](const Parameter &p) { return p.name == name; });
}

void Statement::Add(std::string type, std::string name, std::vector<std::string> values) {
    parameters.insert(parameters.begin(), {std::move(type), std::move(name), std::move(values), loc,
                                           /*comments=*/{}, /*remark=*/{}});
}

std::string Quoted(std::string_view name) {
    return '"' + std::string(name) + '"';
}

std::string Unquoted(std::string_view written) {
    if (written.size() >= 2 && written.front() == '"' && written.back() == '"')
        written = written.substr(1, written.size() - 2);
    return std::string(written);
}

std::optional<std::vector<float>> Numbers(const Parameter &p) {
    std::vector<float> numbers;
    numbers.reserve(p.values.size());
    for (const std::string &value : p.values) {
        const std::optional<float> number = ParseFloat(value);
        if (!number) return {};
        numbers.push_back(*number);
    }
    return numbers;
}

}  // namespace pbrt::rewrite
