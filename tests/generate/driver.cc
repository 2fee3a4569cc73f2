// The client in C++ that a test controls: the commands of driver.c, each answered by the status and the results, or by
// the sentence of the error.
#include "unity_link.hpp"

#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>

namespace {

using unity_link::Seconds;
using unity_link::Words;

std::unique_ptr<unity_link::Link> the_link;
std::map<std::uint64_t, unity_link::Subscription> subscriptions;

unity_link::Link &link()
{
    if (!the_link) throw unity_link::LinkLostError(UL_LOST_NOT_EXECUTED, "the link was closed");
    return *the_link;
}

std::uint64_t number(std::istream &rest)
{
    std::uint64_t value = 0;
    rest >> std::hex >> value;
    return value;
}

std::uint32_t address(std::istream &rest) { return static_cast<std::uint32_t>(number(rest)); }

Words numbers(std::istream &rest)
{
    Words values;
    for (std::uint64_t value = 0; rest >> std::hex >> value;) values.push_back(value);
    return values;
}

std::vector<std::uint32_t> addresses(std::istream &rest)
{
    std::vector<std::uint32_t> values;
    for (std::uint64_t value : numbers(rest)) values.push_back(static_cast<std::uint32_t>(value));
    return values;
}

Seconds seconds(std::istream &rest)
{
    std::string text;
    rest >> text;
    return Seconds{std::stod(text)};
}

Words connect(std::istream &rest)
{
    std::string url;
    rest >> url;
    subscriptions.clear();
    the_link.reset();
    the_link = std::make_unique<unity_link::Link>(url, seconds(rest));
    return {};
}

Words write_many(std::istream &rest)
{
    std::vector<std::uint32_t> places;
    Words words;
    for (std::uint64_t value : numbers(rest)) {
        if (places.size() == words.size()) places.push_back(static_cast<std::uint32_t>(value));
        else words.push_back(value);
    }
    link().write_many(places, words);
    return {};
}

Words subscribe(std::istream &rest)
{
    std::uint64_t which = number(rest);
    unity_link::Schedule schedule;
    std::string flags;
    schedule.rate_hz = seconds(rest).count();
    rest >> flags;
    subscriptions.erase(which);
    subscriptions.emplace(which, unity_link::Subscription{link(), addresses(rest), schedule});
    return {};
}

// Prints sequence number, losses and time as driver.c does, before the words.
void print_next(std::istream &rest)
{
    auto &subscription = subscriptions.at(number(rest));
    auto sample = subscription.next(seconds(rest));
    if (!sample) throw unity_link::GatewayError(UL_NO_SAMPLE, "no sample came in time");
    std::printf("0 %llu %llu %a", static_cast<unsigned long long>(sample->sequence),
                static_cast<unsigned long long>(sample->lost), sample->time.count());
    for (std::uint64_t word : sample->words) std::printf(" %llu", static_cast<unsigned long long>(word));
}

using Command = std::function<Words(std::istream &)>;

const std::map<std::string, Command> COMMANDS = {
    {"connect", connect},
    {"close", [](std::istream &) { if (the_link) the_link->close(); return Words{}; }},
    {"read", [](std::istream &rest) { return Words{link().read(address(rest))}; }},
    {"write", [](std::istream &rest) { auto at = address(rest); link().write(at, number(rest)); return Words{}; }},
    {"masked", [](std::istream &rest) {
        auto at = address(rest);
        auto word = number(rest);
        return Words{link().write_masked(at, word, number(rest))};
    }},
    {"post", [](std::istream &rest) { auto at = address(rest); link().post(at, number(rest)); return Words{}; }},
    {"fence", [](std::istream &) { link().fence(); return Words{}; }},
    {"rblock", [](std::istream &rest) { auto at = address(rest); return link().read_block(at, number(rest)); }},
    {"wblock", [](std::istream &rest) { auto at = address(rest); link().write_block(at, numbers(rest)); return Words{}; }},
    {"rqueue", [](std::istream &rest) { auto at = address(rest); return link().read_queue(at, number(rest)); }},
    {"wqueue", [](std::istream &rest) { auto at = address(rest); link().write_queue(at, numbers(rest)); return Words{}; }},
    {"rmany", [](std::istream &rest) { return link().read_many(addresses(rest)); }},
    {"wmany", write_many},
    {"subscribe", subscribe},
    {"publish", [](std::istream &rest) { subscriptions.at(number(rest)).publish(); return Words{}; }},
    {"unsubscribe", [](std::istream &rest) { subscriptions.at(number(rest)).stop(); return Words{}; }},
};

void answer(const std::string &line)
{
    std::istringstream rest{line};
    std::string name;
    rest >> name;
    if (name == "next") {
        print_next(rest);
        return;
    }
    Words words = COMMANDS.at(name)(rest);
    std::printf("0");
    for (std::uint64_t word : words) std::printf(" %llu", static_cast<unsigned long long>(word));
}

}  // namespace

int main()
{
    for (std::string line; std::getline(std::cin, line);) {
        try {
            answer(line);
        } catch (const unity_link::Error &error) {
            std::printf("%d %s", error.status(), error.what());
        }
        std::printf("\n");
        std::fflush(stdout);
    }
}
