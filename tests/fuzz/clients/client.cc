// The client in C++, with calls and a gateway that the bytes of an input choose.
#include "medium.h"
#include "robot.hpp"

#include <cstring>
#include <list>

namespace {

enum { MOST_CALLS = 80 };

std::uint32_t next_address()
{
    return static_cast<std::uint32_t>(next_number(next_byte() % 8 == 7 ? 4 : 1));
}

std::uint64_t next_word()
{
    return next_number(next_byte() % 8 == 7 ? 8 : 1);
}

std::size_t next_count()
{
    unsigned count = next_byte();
    return count < 200 ? count % 20 : count % 8 * 75;
}

unity_link::Seconds next_seconds()
{
    return unity_link::Seconds{0.001 * next_byte()};
}

double next_real()
{
    std::uint64_t bits = next_number(8);
    double value;
    std::memcpy(&value, &bits, sizeof value);
    return next_byte() & 1 ? value : static_cast<int>(next_byte());
}

// A program: a link, with the robot and the subscriptions that use it.
class Program {
public:
    explicit Program(const ul_transport &medium) : link_(medium, node, unity_link::Seconds{0.01 * next_byte()}) {}

    void call()
    {
        unsigned choice = next_byte();
        switch (choice % 16) {
        case 0: (void)link_.read(next_address()); break;
        case 1: link_.write(next_address(), next_word()); break;
        case 2: link_.post(next_address(), next_word()); break;
        case 3: (void)link_.write_masked(next_address(), next_word(), next_word()); break;
        case 4: call_block(choice >> 4); break;
        case 5: call_batch(); break;
        case 6: subscribe(); break;
        case 7: call_samples(choice >> 4); break;
        case 8: case 9: call_signals(choice >> 4); break;
        case 10: call_feed(choice >> 4); break;
        case 11: link_.fence(); break;
        case 12: link_.poll(next_seconds()); break;
        case 13: link_.send_immediate(static_cast<unity_link::SendImmediate>(choice >> 4)); break;
        case 14: robot_.emplace(link_, unity_link::any_map, address(choice & 16), address(choice & 32)); break;
        default: link_.close();
        }
    }

private:
    static std::optional<std::uint32_t> address(bool is_given)
    {
        return is_given ? std::optional<std::uint32_t>{0xF0} : std::nullopt;
    }

    void call_block(unsigned choice)
    {
        std::uint32_t at = next_address();
        std::size_t count = next_count();
        switch (choice % 6) {
        case 0: HAS_TO_HOLD(link_.read_block(at, count).size() == count); break;
        case 1: link_.write_block(at, unity_link::Words(count, 1)); break;
        case 2: (void)link_.read_queue(at, count); break;
        case 3: link_.write_queue(at, unity_link::Words(count, 2)); break;
        case 4: (void)link_.read_many(std::vector<std::uint32_t>(count, at)); break;
        default: link_.write_many(std::vector<std::uint32_t>(count, at), unity_link::Words(count, 3));
        }
    }

    void call_batch()
    {
        auto words = std::make_unique<std::array<std::uint64_t, 16>>();
        unity_link::Batch batch{link_};
        for (unsigned count = next_byte() % 16; count-- > 0;) {
            if (next_byte() & 1) batch.read(next_address(), &(*words)[count]);
            else batch.write(next_address(), next_word());
        }
        if (next_byte() & 1) batch.finish();
    }

    void subscribe()
    {
        unity_link::Schedule schedule;
        unsigned flags = next_byte();
        if (flags & 1) schedule.rate_hz = 10.0 * next_byte();
        if (flags & 2) schedule.divisor = static_cast<unsigned>(next_number(3));
        if (flags & 4) schedule.group = next_byte() % 10;
        schedule.trigger = flags & 8;
        schedule.on_change = flags & 16;
        schedule.timestamps = flags & 32;
        schedule.samples = next_byte() % 6;
        unity_link::Subscription::Callback callback;
        if (flags & 64) callback = [this](const unity_link::Sample &sample) { called_back(sample); };
        std::vector<std::uint32_t> addresses(next_count(), 1);
        if (subscriptions_.size() > 3) subscriptions_.pop_front();
        subscriptions_.emplace_back(link_, std::move(addresses), schedule, std::move(callback));
    }

    // A callback may end its own subscription, use the link, and throw.
    void called_back(const unity_link::Sample &sample)
    {
        switch (next_byte() % 8) {
        case 0: subscriptions_.clear(); break;
        case 1: link_.post(0x7F, sample.sequence); break;
        case 2: throw std::runtime_error("a callback may throw");
        case 3: link_.poll(unity_link::Seconds{0.001}); break;
        case 4: link_.close(); break;
        default: break;
        }
    }

    void call_samples(unsigned choice)
    {
        if (subscriptions_.empty()) return;
        unity_link::Subscription &one = subscriptions_.back();
        switch (choice % 5) {
        case 0: (void)one.next(next_seconds()); break;
        case 1: one.publish(); break;
        case 2: one.stop(); break;
        case 3: {
            unity_link::Subscription moved{std::move(one)};
            subscriptions_.pop_back();
            (void)moved.next(next_seconds());
            subscriptions_.push_back(std::move(moved));
            break;
        }
        default: subscriptions_.pop_front();
        }
    }

    void call_signals(unsigned choice)
    {
        if (!robot_) robot_.emplace(link_, unity_link::any_map, std::nullopt, std::nullopt);
        Robot &robot = *robot_;
        switch (choice % 12) {
        case 0: (void)robot.angle.get(); break;
        case 1: robot.angle.set(next_real()); break;
        case 2: robot.arms[1].warm.post(next_real()); break;
        case 3: (void)robot.far.get(); break;
        case 4: robot.far.set(static_cast<std::int64_t>(next_number(8))); break;
        case 5: robot.arms[0].count.set(next_number(8)); break;
        case 6: robot.enable.set(next_byte() % 2 == 1); break;
        case 7: robot.mode.set(static_cast<Robot::Mode>(next_byte())); break;
        case 8: (void)to_string(robot.mode.get()); break;
        case 9: (void)robot.state.read(); break;
        case 10: robot.joint.set(static_cast<int>(next_byte())); break;
        default: (void)robot.networks.at(0).state();
        }
    }

    void call_feed(unsigned choice)
    {
        if (!robot_) robot_.emplace(link_, unity_link::any_map, std::nullopt, std::nullopt);
        if (choice & 1) feeds_.clear();
        if (feeds_.empty()) feeds_.push_back(robot_->state.subscribe());
        (void)feeds_.back().next(next_seconds());
    }

    unity_link::Link link_;
    std::optional<Robot> robot_;
    std::list<unity_link::Subscription> subscriptions_;
    std::list<unity_link::Feed<Robot::State>> feeds_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    begin_input(data, size);
    while (input_left > 0) {
        std::optional<Program> program;
        ul_transport medium = open_medium();
        try {
            program.emplace(medium);
        } catch (const unity_link::Error &error) {
            HAS_TO_HOLD(*error.what() != '\0');
            HAS_TO_HOLD(!is_open);
            continue;
        }
        for (unsigned calls = 0; input_left > 0 && calls < MOST_CALLS; calls++) {
            try {
                program->call();
            } catch (const unity_link::Error &error) {
                HAS_TO_HOLD(*error.what() != '\0');
                HAS_TO_HOLD(!error.code().message().empty());
            } catch (const std::runtime_error &) {
                // A callback has thrown.
            } catch (const std::out_of_range &) {
                // The networks do not exist before their first use.
            }
        }
        program.reset();
        HAS_TO_HOLD(!is_open);
    }
    return 0;
}
