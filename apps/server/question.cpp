#include "question.hpp"

namespace spectralpack::server {

std::string last_line(const std::filesystem::path& file) {
    std::string text = read_text(file).value_or("");
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) {
        text.pop_back();
    }
    text = text.substr(text.rfind('\n') + 1);
    constexpr std::string_view kProgram = "spectralpack: ";
    return text.starts_with(kProgram) ? text.substr(kProgram.size()) : text;
}

Question::Question(const std::filesystem::path& folder, const std::string& name, const Json& said)
    : asked(folder / (name + "-asked.json")), answer(folder / (name + ".json")), errors(folder / (name + ".txt")) {
    std::filesystem::create_directories(folder);
    if (!said.is_null()) write_text(asked, said.dump());
}

void Question::remove() const {
    std::error_code none;
    for (const std::filesystem::path& path : {asked, answer, errors}) {
        std::filesystem::remove(path, none);
    }
}

}  // namespace spectralpack::server
