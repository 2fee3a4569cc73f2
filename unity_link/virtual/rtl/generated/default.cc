// 89d9e638ff2c69be names what this was made from: unity_link_fifo in its configuration 'default', by GHDL and Yosys 0.70.0.
// Made by `make rtl`: change the VHDL in gateware/rtl instead.

#include <cxxrtl/cxxrtl.h>

#if defined(CXXRTL_INCLUDE_CAPI_IMPL) || \
    defined(CXXRTL_INCLUDE_VCD_CAPI_IMPL)
#include <cxxrtl/capi/cxxrtl_capi.cc>
#endif

#if defined(CXXRTL_INCLUDE_VCD_CAPI_IMPL)
#include <cxxrtl/capi/cxxrtl_capi_vcd.cc>
#endif

using namespace cxxrtl_yosys;

namespace cxxrtl_design {

// \top: 1
// \src: top.v:13214.1-13307.10
struct p_unity__link__fifo : public module {
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst tick_inst n6616_q
	// \src: top.v:941.13-941.20
	wire<6> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6616__q;
	// \hdlname: unity_link_inst core_inst request_executor_inst memory_kept
	// \src: top.v:6692.15-6692.26
	wire<32> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3359_q
	// \src: top.v:7388.14-7388.21
	wire<75> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2141_q
	// \src: top.v:9701.15-9701.22
	wire<142> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q;
	// \hdlname: unity_link_inst core_inst request_executor_inst ring_room
	// \src: top.v:6649.17-6649.26
	wire<9> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room;
	// \hdlname: unity_link_inst core_inst frame_writer_inst sample_word
	// \src: top.v:1845.18-1845.29
	wire<32> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__word;
	// \hdlname: unity_link_inst core_inst frame_writer_inst sample_available
	// \src: top.v:1844.11-1844.27
	wire<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available;
	// \hdlname: unity_link_inst core_inst frame_writer_inst response_word
	// \src: top.v:1843.18-1843.31
	wire<32> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst committed
	// \src: top.v:3779.15-3779.24
	wire<11> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed;
	// \hdlname: unity_link_inst core_inst response_ring_inst n3436_q
	// \src: top.v:6559.13-6559.20
	wire<9> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3436__q;
	// \hdlname: unity_link_inst core_inst response_ring_inst n3434_q
	// \src: top.v:6557.13-6557.20
	wire<9> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3434__q;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6448_q
	// \src: top.v:1428.14-1428.21
	wire<26> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q;
	// \hdlname: unity_link_inst core_inst response_ring_inst committed
	// \src: top.v:6538.14-6538.23
	wire<9> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst n5014_q
	// \src: top.v:3798.14-3798.21
	wire<11> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5014__q;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst n5016_q
	// \src: top.v:3800.14-3800.21
	wire<11> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5016__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3693_q
	// \src: top.v:3972.14-3972.21
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3693__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3692_q
	// \src: top.v:3971.14-3971.21
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3692__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3691_q
	// \src: top.v:3970.14-3970.21
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3691__q;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst out_ready
	// \src: top.v:1256.11-1256.20
	wire<1> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_out__ready;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst group_state
	// \src: top.v:3909.14-3909.25
	wire<10> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst is_set
	// \src: top.v:3918.15-3918.21
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst due_by_timer
	// \src: top.v:3919.15-3919.27
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst due_by_trigger
	// \src: top.v:3920.15-3920.29
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__trigger;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst tick
	// \src: top.v:3927.8-3927.12
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst lost
	// \src: top.v:3932.14-3932.18
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst lost_kept
	// \src: top.v:3933.14-3933.23
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost__kept;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst asked
	// \src: top.v:3936.14-3936.19
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst changed
	// \src: top.v:3938.8-3938.15
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst failed
	// \src: top.v:3939.8-3939.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst last_read
	// \src: top.v:3940.15-3940.24
	wire<32> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__read;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst last_word
	// \src: top.v:3941.15-3941.24
	wire<32> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__word;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst address_read
	// \src: top.v:3942.14-3942.26
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_address__read;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3649_q
	// \src: top.v:6200.14-6200.21
	wire<32> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3647_q
	// \src: top.v:6198.14-6198.21
	wire<11> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3646_q
	// \src: top.v:6197.7-6197.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3644_q
	// \src: top.v:6195.7-6195.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3643_q
	// \src: top.v:6194.7-6194.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3643__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3641_q
	// \src: top.v:6192.13-6192.20
	wire<2> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3641__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst exclusive
	// \src: top.v:6100.8-6100.17
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive;
	// \hdlname: unity_link_inst core_inst bus_master_inst for_sample
	// \src: top.v:6097.8-6097.18
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample;
	// \hdlname: unity_link_inst core_inst bus_master_inst sample_address
	// \src: top.v:6081.17-6081.31
	wire<8> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample__address;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst kept_valid
	// \src: top.v:22.8-22.18
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst kept_index
	// \src: top.v:23.14-23.24
	wire<4> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst kept_divisor
	// \src: top.v:24.15-24.27
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst kept_counter
	// \src: top.v:25.15-25.27
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst kept_losses
	// \src: top.v:26.14-26.25
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__losses;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6134_q
	// \src: top.v:2344.14-2344.21
	wire<32> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6134__q;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6133_q
	// \src: top.v:2343.14-2343.21
	wire<93> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n925_q
	// \src: top.v:11335.14-11335.20
	wire<62> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6552_data
	// \src: top.v:1114.13-1114.23
	wire<10> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6552__data;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6551_q
	// \src: top.v:1113.7-1113.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6551__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6544_q
	// \src: top.v:1108.13-1108.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6544__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6543_q
	// \src: top.v:1107.13-1107.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6543__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst bypass
	// \src: top.v:1067.14-1067.20
	wire<10> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst count
	// \src: top.v:1061.14-1061.19
	wire<9> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst n6594_q
	// \src: top.v:994.7-994.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6594__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst count
	// \src: top.v:11980.14-11980.19
	wire<9> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst bypass
	// \src: top.v:11986.14-11986.20
	wire<9> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n333_q
	// \src: top.v:12026.13-12026.19
	wire<8> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n333__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n334_q
	// \src: top.v:12027.13-12027.19
	wire<8> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n334__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n341_q
	// \src: top.v:12032.7-12032.13
	wire<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n341__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n342_data
	// \src: top.v:12033.13-12033.22
	wire<9> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n342__data;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst its_mark
	// \src: top.v:974.14-974.22
	wire<2> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst has_left
	// \src: top.v:973.8-973.16
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6923_q
	// \src: top.v:178.7-178.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6923__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6924_q
	// \src: top.v:179.13-179.20
	wire<4> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6924__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6925_q
	// \src: top.v:180.7-180.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6925__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6926_q
	// \src: top.v:181.13-181.20
	wire<4> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6926__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6939_data
	// \src: top.v:188.14-188.24
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6939__data;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6943_data
	// \src: top.v:189.14-189.24
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6943__data;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6949_data
	// \src: top.v:191.13-191.23
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6949__data;
	// \hdlname: unity_link_inst core_inst with_groups_ring_room
	// \src: top.v:12456.15-12456.36
	wire<11> p_unity__link__inst_2e_core__inst_2e_with__groups__ring__room;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4907_data
	// \src: top.v:4538.13-4538.23
	wire<10> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4907__data;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4903_data
	// \src: top.v:4537.14-4537.24
	wire<14> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4903__data;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4893_q
	// \src: top.v:4531.13-4531.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4893__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4891_q
	// \src: top.v:4529.14-4529.21
	wire<32> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4891__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4889_q
	// \src: top.v:4527.7-4527.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4889__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4888_q
	// \src: top.v:4526.13-4526.20
	wire<4> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4887_q
	// \src: top.v:4525.7-4525.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4887__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4884_q
	// \src: top.v:4522.14-4522.21
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4881_q
	// \src: top.v:4520.14-4520.21
	wire<14> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4881__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4879_q
	// \src: top.v:4519.13-4519.20
	wire<4> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4878_q
	// \src: top.v:4518.13-4518.20
	wire<2> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4878__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4877_q
	// \src: top.v:4517.13-4517.20
	wire<3> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4877__q;
	// \hdlname: unity_link_inst core_inst group_is_set
	// \src: top.v:12333.8-12333.20
	wire<1> p_unity__link__inst_2e_core__inst_2e_group__is__set;
	// \hdlname: unity_link_inst core_inst access_failure
	// \src: top.v:12331.14-12331.28
	wire<4> p_unity__link__inst_2e_core__inst_2e_access__failure;
	// \hdlname: unity_link_inst core_inst memory_word
	// \src: top.v:12311.15-12311.26
	wire<32> p_unity__link__inst_2e_core__inst_2e_memory__word;
	// \hdlname: unity_link_inst core_inst character_valid
	// \src: top.v:12282.8-12282.23
	wire<1> p_unity__link__inst_2e_core__inst_2e_character__valid;
	// \hdlname: unity_link_inst core_inst character_in
	// \src: top.v:12281.14-12281.26
	wire<9> p_unity__link__inst_2e_core__inst_2e_character__in;
	// \hdlname: unity_link_inst core_inst fifo_out_valid
	// \src: top.v:12279.8-12279.22
	wire<1> p_unity__link__inst_2e_core__inst_2e_fifo__out__valid;
	// \hdlname: unity_link_inst core_inst flush
	// \src: top.v:12271.11-12271.16
	wire<1> p_unity__link__inst_2e_core__inst_2e_flush;
	// \src: top.v:13235.18-13235.26
	/*output*/ wire<32> p_wb__dat__o;
	// \src: top.v:13234.17-13234.23
	/*output*/ wire<8> p_wb__adr;
	// \src: top.v:13233.17-13233.23
	/*output*/ value<4> p_wb__sel;
	// \src: top.v:13232.11-13232.16
	/*output*/ wire<1> p_wb__we;
	// \src: top.v:13231.11-13231.17
	/*output*/ wire<1> p_wb__stb;
	// \src: top.v:13230.11-13230.17
	/*output*/ value<1> p_wb__cyc;
	// \src: top.v:13229.11-13229.20
	/*output*/ wire<1> p_out__flush;
	// \src: top.v:13228.11-13228.20
	/*output*/ wire<1> p_out__valid;
	// \src: top.v:13227.17-13227.25
	/*output*/ value<8> p_out__data;
	// \src: top.v:13226.11-13226.19
	/*output*/ wire<1> p_in__ready;
	// \src: top.v:13225.11-13225.19
	/*input*/ value<1> p_wb__stall;
	// \src: top.v:13224.11-13224.17
	/*input*/ value<1> p_wb__err;
	// \src: top.v:13223.11-13223.17
	/*input*/ value<1> p_wb__ack;
	// \src: top.v:13222.18-13222.26
	/*input*/ value<32> p_wb__dat__i;
	// \src: top.v:13221.18-13221.25
	/*input*/ value<16> p_trigger;
	// \src: top.v:13220.11-13220.20
	/*input*/ value<1> p_out__ready;
	// \src: top.v:13219.11-13219.19
	/*input*/ value<1> p_in__valid;
	// \src: top.v:13218.11-13218.18
	/*input*/ value<1> p_in__lost;
	// \src: top.v:13217.17-13217.24
	/*input*/ value<8> p_in__data;
	// \src: top.v:13216.11-13216.14
	/*input*/ value<1> p_rst;
	// \src: top.v:13215.11-13215.14
	/*input*/ value<1> p_clk;
	value<1> prev_p_clk;
	bool posedge_p_clk() const {
		return !prev_p_clk.slice<0>().val() && p_clk.slice<0>().val();
	}
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst losses
	// \src: top.v:666.13-666.19
	memory<8> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses { 16u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst counters
	// \src: top.v:638.14-638.22
	memory<16> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters { 16u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst divisors
	// \src: top.v:610.14-610.22
	memory<16> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors { 16u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6135
	// \src: top.v:3486.13-3486.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6135 { 64u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6137
	// \src: top.v:3556.13-3556.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6137 { 64u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6139
	// \src: top.v:3626.13-3626.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6139 { 64u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6141
	// \src: top.v:3696.13-3696.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6141 { 64u };
	// \hdlname: unity_link_inst core_inst response_ring_inst memory
	// \src: top.v:6622.14-6622.20
	memory<32> memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory { 256u };
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst memory
	// \src: top.v:3863.14-3863.20
	memory<32> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_memory { 1024u };
	// \hdlname: unity_link_inst core_inst tx_fifo_inst memory
	// \no_rw_check: 1
	// \src: top.v:1237.36-1237.42
	memory<10> memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory { 256u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst settings_memory
	// \src: top.v:5911.14-5911.29
	memory<14> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory { 16u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst state_memory
	// \src: top.v:5939.13-5939.25
	memory<10> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory { 16u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst list
	// \src: top.v:5967.13-5967.17
	memory<8> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_list { 512u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst last
	// \src: top.v:5977.14-5977.18
	memory<32> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last { 1024u };
	// \hdlname: unity_link_inst core_inst rx_fifo_inst memory
	// \no_rw_check: 1
	// \src: top.v:12156.36-12156.42
	memory<9> memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory { 256u };
	// \hdlname: unity_link_inst core_inst request_memory_inst memory
	// \src: top.v:9079.14-9079.20
	memory<32> memory_p_unity__link__inst_2e_core__inst_2e_request__memory__inst_2e_memory { 256u };

	p_unity__link__fifo(interior) {}
	p_unity__link__fifo() {
		reset();
	};

	void reset() override;

	bool eval(performer *performer = nullptr) override;

	template<class ObserverT>
	bool commit(ObserverT &observer) {
		bool changed = false;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6616__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__word.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3436__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3434__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5014__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5016__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3693__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3692__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3691__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_out__ready.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__trigger.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost__kept.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__read.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__word.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_address__read.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3643__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3641__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample__address.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__losses.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6134__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6552__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6551__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6544__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6543__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6594__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n333__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n334__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n341__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n342__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6923__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6924__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6925__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6926__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6939__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6943__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6949__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__ring__room.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4907__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4903__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4893__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4891__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4889__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4887__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4881__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4878__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4877__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_group__is__set.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_access__failure.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_memory__word.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_character__valid.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_character__in.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_flush.commit(observer)) changed = true;
		if (p_wb__dat__o.commit(observer)) changed = true;
		if (p_wb__adr.commit(observer)) changed = true;
		if (p_wb__we.commit(observer)) changed = true;
		if (p_wb__stb.commit(observer)) changed = true;
		if (p_out__flush.commit(observer)) changed = true;
		if (p_out__valid.commit(observer)) changed = true;
		if (p_in__ready.commit(observer)) changed = true;
		prev_p_clk = p_clk;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_list.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_request__memory__inst_2e_memory.commit(observer)) changed = true;
		return changed;
	}

	bool commit() override {
		observer observer;
		return commit<>(observer);
	}
}; // struct p_unity__link__fifo

void p_unity__link__fifo::reset() {
	static const value<8> mem_init_1[16] {
		value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u},
		value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u},
		value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u},
		value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u},
	};
	std::copy(std::begin(mem_init_1), std::end(mem_init_1), &memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses.data[0]);
	static const value<16> mem_init_2[16] {
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
	};
	std::copy(std::begin(mem_init_2), std::end(mem_init_2), &memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters.data[0]);
	static const value<16> mem_init_3[16] {
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
	};
	std::copy(std::begin(mem_init_3), std::end(mem_init_3), &memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors.data[0]);
	static const value<4> mem_init_4[64] {
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0xau},
		value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x6u}, value<4>{0x9u},
		value<4>{0x8u}, value<4>{0x9u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0xfu}, value<4>{0x7u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x2u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_4), std::end(mem_init_4), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6135.data[0]);
	static const value<4> mem_init_5[64] {
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0xau},
		value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x6u}, value<4>{0x9u},
		value<4>{0x8u}, value<4>{0x9u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0xfu}, value<4>{0x7u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x2u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_5), std::end(mem_init_5), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6137.data[0]);
	static const value<4> mem_init_6[64] {
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0xau},
		value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x6u}, value<4>{0x9u},
		value<4>{0x8u}, value<4>{0x9u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0xfu}, value<4>{0x7u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x2u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_6), std::end(mem_init_6), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6139.data[0]);
	static const value<4> mem_init_7[64] {
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0xau},
		value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x6u}, value<4>{0x9u},
		value<4>{0x8u}, value<4>{0x9u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0xfu}, value<4>{0x7u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x2u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_7), std::end(mem_init_7), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6141.data[0]);
	static const value<14> mem_init_8[16] {
		value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u},
		value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u},
		value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u},
		value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u},
	};
	std::copy(std::begin(mem_init_8), std::end(mem_init_8), &memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory.data[0]);
	static const value<10> mem_init_9[16] {
		value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u},
		value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u},
		value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u},
		value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u},
	};
	std::copy(std::begin(mem_init_9), std::end(mem_init_9), &memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory.data[0]);
}

bool p_unity__link__fifo::eval(performer *performer) {
	bool converged = true;
	bool posedge_p_clk = this->posedge_p_clk();
	// \hdlname: unity_link_inst core_inst request_executor_inst n2539_o
	// \src: top.v:6856.8-6856.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2539__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5431_o
	// \src: top.v:2030.8-2030.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5431__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1524_o
	// \src: top.v:9389.8-9389.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1524__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1526_o
	// \src: top.v:9390.8-9390.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1526__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1527_o
	// \src: top.v:9391.8-9391.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1530_o
	// \src: top.v:9392.8-9392.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1530__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1556_o
	// \src: top.v:9400.8-9400.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5422_o
	// \src: top.v:2028.8-2028.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5422__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1584_o
	// \src: top.v:9409.8-9409.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1601_o
	// \src: top.v:9411.13-9411.20
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5404_o
	// \src: top.v:2024.8-2024.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5404__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1612_o
	// \src: top.v:9415.8-9415.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1612__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1618_o
	// \src: top.v:9418.8-9418.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1618__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1621_o
	// \src: top.v:9419.8-9419.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1621__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1624_o
	// \src: top.v:9420.8-9420.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1624__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5392_o
	// \src: top.v:2020.8-2020.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5392__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5099_o
	// \src: top.v:1903.8-1903.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5099__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1643_o
	// \src: top.v:9430.14-9430.21
	value<9> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1643__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst tick_inst n6602_o
	// \src: top.v:936.8-936.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6602__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3025_o
	// \src: top.v:7137.15-7137.22
	value<14> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3025__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1679_o
	// \src: top.v:9464.16-9464.23
	value<117> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1679__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1682_o
	// \src: top.v:9467.8-9467.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1682__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1691_o
	// \src: top.v:9473.8-9473.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1695_o
	// \src: top.v:9476.8-9476.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1695__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5338_o
	// \src: top.v:2005.8-2005.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5338__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1698_o
	// \src: top.v:9478.8-9478.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1698__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1699_o
	// \src: top.v:9479.8-9479.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1699__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1700_o
	// \src: top.v:9480.8-9480.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1700__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3276_o
	// \src: top.v:7337.8-7337.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3276__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5329_o
	// \src: top.v:2003.8-2003.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5329__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5320_o
	// \src: top.v:2001.8-2001.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5320__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5311_o
	// \src: top.v:1999.8-1999.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5311__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5302_o
	// \src: top.v:1997.8-1997.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5302__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5096_o
	// \src: top.v:1901.8-1901.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5096__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5301_o
	// \src: top.v:1996.8-1996.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5301__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1757_o
	// \src: top.v:9502.8-9502.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1757__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2395_o
	// \src: top.v:6783.8-6783.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2395__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5295_o
	// \src: top.v:1992.8-1992.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5295__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5292_o
	// \src: top.v:1990.8-1990.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5292__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6013_o
	// \src: top.v:2273.13-2273.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6013__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5281_o
	// \src: top.v:1987.8-1987.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5281__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1791_o
	// \src: top.v:9521.8-9521.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1791__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1794_o
	// \src: top.v:9523.8-9523.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1794__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5280_o
	// \src: top.v:1986.8-1986.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5280__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1800_o
	// \src: top.v:9527.8-9527.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1800__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1801_o
	// \src: top.v:9528.8-9528.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1801__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1804_o
	// \src: top.v:9530.8-9530.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1804__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5277_o
	// \src: top.v:1984.8-1984.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5277__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2369_o
	// \src: top.v:6768.8-6768.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2369__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2345_o
	// \src: top.v:6760.8-6760.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5252_o
	// \src: top.v:1976.8-1976.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5252__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2342_o
	// \src: top.v:6758.8-6758.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2342__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1848_o
	// \src: top.v:9554.8-9554.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1848__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1850_o
	// \src: top.v:9555.8-9555.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1850__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1854_o
	// \src: top.v:9558.8-9558.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1854__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5248_o
	// \src: top.v:1975.8-1975.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5248__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2323_o
	// \src: top.v:6749.8-6749.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2323__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2316_o
	// \src: top.v:6748.8-6748.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2316__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1892_o
	// \src: top.v:9572.8-9572.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1892__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5233_o
	// \src: top.v:1970.14-1970.21
	value<2> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5233__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2312_o
	// \src: top.v:6746.8-6746.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2312__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1898_o
	// \src: top.v:9576.8-9576.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1898__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1904_o
	// \src: top.v:9580.8-9580.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1904__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3458__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1945_o
	// \src: top.v:9602.8-9602.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1945__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1951_o
	// \src: top.v:9603.8-9603.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1951__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1959_o
	// \src: top.v:9605.8-9605.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1959__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3459__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3460__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3461__CMP;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2279_o
	// \src: top.v:6727.8-6727.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2279__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3462__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1970_o
	// \src: top.v:9614.8-9614.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1970__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3463__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3464__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3465__CMP;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2251_o
	// \src: top.v:6717.8-6717.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2251__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4564_o
	// \src: top.v:4371.14-4371.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4564__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2003_o
	// \src: top.v:9632.8-9632.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2003__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2226_o
	// \src: top.v:6707.8-6707.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2226__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4370_o
	// \src: top.v:4273.8-4273.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4370__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3256_o
	// \src: top.v:7323.8-7323.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3256__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2214_o
	// \src: top.v:6703.8-6703.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2214__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2211_o
	// \src: top.v:6701.8-6701.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2211__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5226_o
	// \src: top.v:1963.15-1963.22
	value<22> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5226__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2062_o
	// \src: top.v:9664.14-9664.21
	value<10> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2062__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst failed
	// \src: top.v:6691.8-6691.14
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed;
	// \hdlname: unity_link_inst core_inst request_executor_inst last_word
	// \src: top.v:6689.8-6689.17
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word;
	// \hdlname: unity_link_inst core_inst request_executor_inst is_masked
	// \src: top.v:6687.8-6687.17
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked;
	// \hdlname: unity_link_inst core_inst request_executor_inst is_queue
	// \src: top.v:6686.8-6686.16
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2082_o
	// \src: top.v:9684.16-9684.23
	value<142> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2082__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5974_o
	// \src: top.v:2256.8-2256.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5974__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2084_o
	// \src: top.v:9686.8-9686.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2084__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4605_o
	// \src: top.v:4390.8-4390.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4605__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4328_o
	// \src: top.v:4261.8-4261.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4328__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4612_o
	// \src: top.v:4394.8-4394.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4612__o;
	// \src: top.v:688.3-690.40
	value<8> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6949__data_5b_7_3a_0_5d_;
	// \src: top.v:685.3-687.37
	value<8> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6947__data_5b_7_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5223_o
	// \src: top.v:1960.14-1960.21
	value<9> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5223__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5068_o
	// \src: top.v:1883.8-1883.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5068__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4618_o
	// \src: top.v:4397.8-4397.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4618__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3246_o
	// \src: top.v:7318.8-7318.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3246__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5046_o
	// \src: top.v:1869.8-1869.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5046__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5038_o
	// \src: top.v:1867.8-1867.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5038__o;
	// \src: top.v:657.3-659.42
	value<16> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6943__data_5b_15_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4624_o
	// \src: top.v:4400.8-4400.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4624__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3242_o
	// \src: top.v:7316.14-7316.21
	value<2> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3242__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst load_word
	// \src: top.v:1860.8-1860.17
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word;
	// \hdlname: unity_link_inst core_inst frame_writer_inst advance
	// \src: top.v:1857.8-1857.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4318_o
	// \src: top.v:4259.8-4259.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4318__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3934__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3933__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3932__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3931__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3930__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3929__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3928__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4315_o
	// \src: top.v:4258.14-4258.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4315__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3927__CMP;
	// \src: top.v:6623.3-6625.37
	value<32> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3441__data_5b_31_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4298_o
	// \src: top.v:4250.8-4250.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4298__o;
	// \src: top.v:5978.3-5980.35
	value<32> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4913__data_5b_31_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4089_o
	// \src: top.v:4182.8-4182.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4089__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4291_o
	// \src: top.v:4249.8-4249.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4291__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6327_o
	// \src: top.v:1357.14-1357.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6327__o_5b_2_3a_0_5d_;
	// \src: top.v:5968.3-5970.35
	value<8> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4910__data_5b_7_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4028__CMP;
	// \src: top.v:5958.3-5960.42
	value<10> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4907__data_5b_9_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4027__CMP;
	// \src: top.v:5933.3-5935.42
	value<4> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5935_24_1571__ADDR_5b_3_3a_0_5d__24_2009;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4626;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4630;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst n4981_o
	// \src: top.v:3785.15-3785.22
	value<11> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n4981__o;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4638;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4642;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4654_o
	// \src: top.v:4415.8-4415.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4654__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4233__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4232__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4231__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4230__CMP;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4652;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4229__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4660_o
	// \src: top.v:4418.8-4418.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4660__o;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4660;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4050__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4049__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4048__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4047__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4046__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4045__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4044__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst n4985_o
	// \src: top.v:3788.15-3788.22
	value<11> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n4985__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3828_o
	// \src: top.v:4058.8-4058.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3828__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3836_o
	// \src: top.v:4060.8-4060.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3836__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3838_o
	// \src: top.v:4061.8-4061.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3838__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3845_o
	// \src: top.v:4062.8-4062.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3845__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3851_o
	// \src: top.v:4065.8-4065.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3851__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3856_o
	// \src: top.v:4068.8-4068.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3856__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3861_o
	// \src: top.v:4071.8-4071.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3861__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3866_o
	// \src: top.v:4074.8-4074.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3866__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3871_o
	// \src: top.v:4077.8-4077.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3871__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3876_o
	// \src: top.v:4080.8-4080.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3876__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3881_o
	// \src: top.v:4083.8-4083.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3881__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3886_o
	// \src: top.v:4086.8-4086.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3886__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3891_o
	// \src: top.v:4089.8-4089.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3891__o;
	// \hdlname: unity_link_inst core_inst response_ring_inst n3401_o
	// \src: top.v:6544.14-6544.21
	value<9> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3401__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6419_o
	// \src: top.v:1410.8-1410.15
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6419__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4514_o
	// \src: top.v:4343.8-4343.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4514__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6410_o
	// \src: top.v:1408.8-1408.15
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6410__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6405_o
	// \src: top.v:1407.8-1407.15
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6405__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4630_o
	// \src: top.v:4403.8-4403.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4630__o;
	// \src: top.v:629.3-631.42
	value<16> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6939__data_5b_15_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4250_o
	// \src: top.v:4233.14-4233.21
	value<9> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4250__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4636_o
	// \src: top.v:4406.8-4406.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4636__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6267_o
	// \src: top.v:1322.14-1322.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6267__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5909_o
	// \src: top.v:2223.13-2223.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5909__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4642_o
	// \src: top.v:4409.8-4409.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4642__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6260_o
	// \src: top.v:1317.14-1317.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6260__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4648_o
	// \src: top.v:4412.8-4412.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4648__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3588__CMP;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6253_o
	// \src: top.v:1312.14-1312.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6253__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4291__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4292__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4293__CMP;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6246_o
	// \src: top.v:1307.14-1307.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6246__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4294__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4296__CMP;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6305_o
	// \src: top.v:1342.14-1342.21
	value<8> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6305__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6291_o
	// \src: top.v:1340.8-1340.15
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6291__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6286_o
	// \src: top.v:1336.15-1336.22
	value<13> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6286__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4297__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3873__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5214_o
	// \src: top.v:1951.15-1951.22
	value<41> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5214__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4298__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4299__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3872__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3803__CMP;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6239_o
	// \src: top.v:1302.14-1302.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6239__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3802__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3801__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3871__CMP;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6232_o
	// \src: top.v:1297.14-1297.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6232__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3870__CMP;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6225_o
	// \src: top.v:1292.14-1292.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6225__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3698_o
	// \src: top.v:3974.15-3974.22
	value<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o;
	// \src: top.v:3864.3-3866.37
	value<32> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_5c_n5021__data_5b_31_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6204_o
	// \src: top.v:1285.13-1285.20
	value<7> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6204__o_5b_6_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6217_o
	// \src: top.v:1287.14-1287.21
	value<8> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6217__o;
	// \src: top.v:1241.3-1243.35
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_1243_24_331__EN_5b_9_3a_0_5d__24_382_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6200_o
	// \src: top.v:1283.8-1283.15
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6200__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3614__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3621__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4348_o
	// \src: top.v:4267.8-4267.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4348__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6154_o
	// \src: top.v:1268.8-1268.15
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6154__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3623__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3627__CMP;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst advance
	// \src: top.v:1263.8-1263.15
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_advance;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3323__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3628__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3340__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3646__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3347__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3353__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3358__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3362__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3365__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4245_o
	// \src: top.v:4229.8-4229.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4245__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3660__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4666_o
	// \src: top.v:4421.8-4421.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4666__o;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4668;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4670;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3377__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3378__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3379__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3380__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4672_o
	// \src: top.v:4424.8-4424.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4672__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3389__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3663__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3390__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3391__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3392__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4678_o
	// \src: top.v:4427.8-4427.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4678__o;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4692;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3401__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3402__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3403__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3404__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3896_o
	// \src: top.v:4092.8-4092.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3896__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4232_o
	// \src: top.v:4224.8-4224.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4232__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4684_o
	// \src: top.v:4430.8-4430.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4684__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3413__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3414__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3421__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3901_o
	// \src: top.v:4095.8-4095.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3901__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3422__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3423__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3424__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3425__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3426__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3427__CMP;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4716;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4690_o
	// \src: top.v:4433.8-4433.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4690__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3906_o
	// \src: top.v:4098.8-4098.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3906__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4223_o
	// \src: top.v:4221.8-4221.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4223__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4212_o
	// \src: top.v:4218.14-4218.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4212__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst carry_out
	// \src: top.v:3916.8-3916.17
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst advance
	// \src: top.v:11018.8-11018.15
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_advance;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst clear_timer
	// \src: top.v:3921.15-3921.26
	value<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4190_o
	// \src: top.v:4212.8-4212.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4190__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n395_o
	// \src: top.v:11036.8-11036.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n395__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4182_o
	// \src: top.v:4206.8-4206.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4182__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4174_o
	// \src: top.v:4204.8-4204.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4174__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n444_o
	// \src: top.v:11051.14-11051.20
	value<8> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n444__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst enough_room
	// \src: top.v:3945.8-3945.19
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst accepted
	// \src: top.v:3946.8-3946.16
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4161_o
	// \src: top.v:4200.8-4200.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4161__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5504_o
	// \src: top.v:2054.14-2054.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5504__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n503_o
	// \src: top.v:11093.14-11093.20
	value<8> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n503__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n504_o
	// \src: top.v:11094.8-11094.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n504__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4535_o
	// \src: top.v:4356.8-4356.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4535__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n535_o
	// \src: top.v:11123.8-11123.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n535__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n544_o
	// \src: top.v:11125.8-11125.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n544__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n545_o
	// \src: top.v:11126.8-11126.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n545__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3559_o
	// \src: top.v:6157.8-6157.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3559__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3557_o
	// \src: top.v:6156.8-6156.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3557__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n559_o
	// \src: top.v:11135.8-11135.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n559__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3176_o
	// \src: top.v:7266.14-7266.21
	value<8> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3176__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n612_o
	// \src: top.v:11146.8-11146.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n612__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3538_o
	// \src: top.v:6146.8-6146.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3538__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6334_o
	// \src: top.v:1362.14-1362.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6334__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n632_o
	// \src: top.v:11155.8-11155.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n632__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n678_o
	// \src: top.v:11174.8-11174.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n678__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3520_o
	// \src: top.v:6135.8-6135.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3520__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n698_o
	// \src: top.v:11183.8-11183.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n698__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3494_o
	// \src: top.v:6121.8-6121.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3494__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3493_o
	// \src: top.v:6120.8-6120.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3493__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3486_o
	// \src: top.v:6119.8-6119.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3486__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6313_o
	// \src: top.v:1347.14-1347.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6313__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3171_o
	// \src: top.v:7262.8-7262.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3171__o;
	// \src: top.v:9080.3-9082.40
	value<32> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2163__data_5b_31_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5138_o
	// \src: top.v:1923.8-1923.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5138__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3465_o
	// \src: top.v:6108.8-6108.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3465__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n764_o
	// \src: top.v:11222.15-11222.21
	value<30> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n764__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3458_o
	// \src: top.v:6107.8-6107.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3458__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3455_o
	// \src: top.v:6106.8-6106.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3455__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n767_o
	// \src: top.v:11225.14-11225.20
	value<8> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n767__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n775_o
	// \src: top.v:11230.8-11230.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n775__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst grant_sample
	// \src: top.v:6103.8-6103.20
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5125_o
	// \src: top.v:1918.8-1918.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5125__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5816_o
	// \src: top.v:2181.13-2181.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5816__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5121_o
	// \src: top.v:1915.8-1915.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5121__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3167_o
	// \src: top.v:7261.8-7261.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3167__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4546_o
	// \src: top.v:4361.8-4361.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4546__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3156_o
	// \src: top.v:7254.14-7254.21
	value<5> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3156__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3154_o
	// \src: top.v:7252.14-7252.21
	value<5> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3154__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst sample
	// \src: top.v:6079.11-6079.17
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3153_o
	// \src: top.v:7251.15-7251.22
	value<31> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3153__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3151_o
	// \src: top.v:7249.15-7249.22
	value<14> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3151__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4340_o
	// \src: top.v:4265.8-4265.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4340__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4181__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5753_o
	// \src: top.v:2155.14-2155.21
	value<6> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5753__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6142_data
	// \src: top.v:2348.14-2348.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6142__data;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6140_data
	// \src: top.v:2347.14-2347.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6140__data;
	// \hdlname: unity_link_inst core_inst request_decoder_inst letter
	// \src: top.v:9122.8-9122.14
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter;
	// \hdlname: unity_link_inst core_inst request_decoder_inst digit
	// \src: top.v:9123.8-9123.13
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit;
	// \hdlname: unity_link_inst core_inst request_decoder_inst field
	// \src: top.v:9124.14-9124.19
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field;
	// \hdlname: unity_link_inst core_inst request_decoder_inst left
	// \src: top.v:9125.14-9125.18
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6138_data
	// \src: top.v:2346.14-2346.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6138__data;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6136_data
	// \src: top.v:2345.14-2345.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6136__data;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n869_o
	// \src: top.v:11287.15-11287.21
	value<26> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n869__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n872_o
	// \src: top.v:11290.14-11290.20
	value<9> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n872__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n875_o
	// \src: top.v:11292.8-11292.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n875__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst is_due
	// \src: top.v:28.8-28.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst counts
	// \src: top.v:30.8-30.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counts;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3911_o
	// \src: top.v:4101.8-4101.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3911__o;
	// \src: top.v:1240.21-1240.27
	value<10> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_1240_24_378__DATA;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3916_o
	// \src: top.v:4104.8-4104.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3916__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6670_o
	// \src: top.v:56.8-56.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6670__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3921_o
	// \src: top.v:4108.8-4108.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3921__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3924_o
	// \src: top.v:4111.15-4111.22
	value<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3924__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n999_o
	// \src: top.v:9148.8-9148.14
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n999__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3928_o
	// \src: top.v:4114.8-4114.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6504_o
	// \src: top.v:1090.8-1090.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6504__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6496_o
	// \src: top.v:1085.8-1085.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6496__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6489_o
	// \src: top.v:1080.8-1080.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6489__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6486_o
	// \src: top.v:1077.8-1077.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6486__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6455_o
	// \src: top.v:1069.8-1069.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6455__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1019_o
	// \src: top.v:9157.8-9157.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1019__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5713_o
	// \src: top.v:2134.13-2134.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5713__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5710_o
	// \src: top.v:2131.8-2131.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5710__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1031_o
	// \src: top.v:9162.8-9162.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3124_o
	// \src: top.v:7222.15-7222.22
	value<14> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3124__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4180__CMP;
	// \src: top.v:5930.3-5932.45
	value<14> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4903__data_5b_13_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1054_o
	// \src: top.v:9170.8-9170.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst n6564_o
	// \src: top.v:981.8-981.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6564__o;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst n6562_o
	// \src: top.v:979.8-979.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6562__o;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst n6559_o
	// \src: top.v:977.8-977.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6559__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1059_o
	// \src: top.v:9173.14-9173.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1064_o
	// \src: top.v:9174.14-9174.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1067_o
	// \src: top.v:9176.8-9176.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1067__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5682_o
	// \src: top.v:2124.8-2124.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5682__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n245_o
	// \src: top.v:11988.8-11988.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n246_o
	// \src: top.v:11989.8-11989.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n276_o
	// \src: top.v:11996.8-11996.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n276__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n279_o
	// \src: top.v:11999.8-11999.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n279__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n286_o
	// \src: top.v:12004.8-12004.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n286__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n294_o
	// \src: top.v:12009.8-12009.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5115_o
	// \src: top.v:1910.8-1910.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5115__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1119_o
	// \src: top.v:9194.8-9194.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1119__o;
	// \hdlname: unity_link_inst bus_done
	// \src: top.v:13063.8-13063.16
	value<1> p_unity__link__inst_2e_bus__done;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1125_o
	// \src: top.v:9197.8-9197.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1125__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1128_o
	// \src: top.v:9198.8-9198.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1128__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1131_o
	// \src: top.v:9199.8-9199.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1131__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2716_o
	// \src: top.v:6961.14-6961.21
	value<8> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2716__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4179__CMP;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2712_o
	// \src: top.v:6958.14-6958.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2712__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2711_o
	// \src: top.v:6957.14-6957.21
	value<3> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2711__o;
	// \src: top.v:12159.20-12159.26
	value<9> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_12159_24_3241__DATA;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6355_o
	// \src: top.v:1377.14-1377.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6355__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1154_o
	// \src: top.v:9212.8-9212.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1154__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1157_o
	// \src: top.v:9215.8-9215.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1157__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2709_o
	// \src: top.v:6955.8-6955.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2709__o;
	// \hdlname: unity_link_inst core_inst n198_o
	// \src: top.v:12490.8-12490.14
	value<1> p_unity__link__inst_2e_core__inst_2e_n198__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1166_o
	// \src: top.v:9224.8-9224.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1166__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4407_o
	// \src: top.v:4290.8-4290.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4407__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2696_o
	// \src: top.v:6942.13-6942.20
	value<2> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2696__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2690_o
	// \src: top.v:6936.13-6936.20
	value<3> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2690__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6320_o
	// \src: top.v:1352.14-1352.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6320__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_ring_write
	// \src: top.v:12452.8-12452.30
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3078_o
	// \src: top.v:7179.14-7179.21
	value<11> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3078__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3068_o
	// \src: top.v:7171.8-7171.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3068__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1249_o
	// \src: top.v:9266.8-9266.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1252_o
	// \src: top.v:9267.8-9267.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1255_o
	// \src: top.v:9268.8-9268.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1258_o
	// \src: top.v:9269.8-9269.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1261_o
	// \src: top.v:9270.8-9270.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1265_o
	// \src: top.v:9271.8-9271.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1268_o
	// \src: top.v:9272.8-9272.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1290_o
	// \src: top.v:9276.8-9276.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1290__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1293_o
	// \src: top.v:9277.8-9277.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3059_o
	// \src: top.v:7168.8-7168.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3059__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1309_o
	// \src: top.v:9282.8-9282.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1309__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1315_o
	// \src: top.v:9284.8-9284.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6341_o
	// \src: top.v:1367.14-1367.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6341__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1339_o
	// \src: top.v:9290.8-9290.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1339__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1345_o
	// \src: top.v:9292.8-9292.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1345__o;
	// \hdlname: unity_link_inst core_inst tx_entry
	// \src: top.v:12364.14-12364.22
	value<10> p_unity__link__inst_2e_core__inst_2e_tx__entry;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1348_o
	// \src: top.v:9293.8-9293.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1348__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1351_o
	// \src: top.v:9294.8-9294.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1351__o;
	// \hdlname: unity_link_inst core_inst answer_has_id
	// \src: top.v:12348.8-12348.21
	value<1> p_unity__link__inst_2e_core__inst_2e_answer__has__id;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1367_o
	// \src: top.v:9298.8-9298.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1367__o;
	// \hdlname: unity_link_inst core_inst answer_taken
	// \src: top.v:12343.8-12343.20
	value<1> p_unity__link__inst_2e_core__inst_2e_answer__taken;
	// \hdlname: unity_link_inst core_inst answer_valid
	// \src: top.v:12342.8-12342.20
	value<1> p_unity__link__inst_2e_core__inst_2e_answer__valid;
	// \hdlname: unity_link_inst core_inst group_done
	// \src: top.v:12336.8-12336.18
	value<1> p_unity__link__inst_2e_core__inst_2e_group__done;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5520_o
	// \src: top.v:2069.8-2069.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5520__o;
	// \hdlname: unity_link_inst core_inst group_request
	// \src: top.v:12334.8-12334.21
	value<1> p_unity__link__inst_2e_core__inst_2e_group__request;
	// \hdlname: unity_link_inst core_inst access_done
	// \src: top.v:12325.8-12325.19
	value<1> p_unity__link__inst_2e_core__inst_2e_access__done;
	// \hdlname: unity_link_inst core_inst access_granted
	// \src: top.v:12324.8-12324.22
	value<1> p_unity__link__inst_2e_core__inst_2e_access__granted;
	// \hdlname: unity_link_inst core_inst access_more
	// \src: top.v:12320.8-12320.19
	value<1> p_unity__link__inst_2e_core__inst_2e_access__more;
	// \hdlname: unity_link_inst core_inst access_write
	// \src: top.v:12319.8-12319.20
	value<1> p_unity__link__inst_2e_core__inst_2e_access__write;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5514_o
	// \src: top.v:2064.8-2064.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5514__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5513_o
	// \src: top.v:2063.14-2063.21
	value<6> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5513__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1404_o
	// \src: top.v:9315.14-9315.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5512_o
	// \src: top.v:2062.14-2062.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5512__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1409_o
	// \src: top.v:9318.8-9318.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1413_o
	// \src: top.v:9321.8-9321.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1419_o
	// \src: top.v:9325.8-9325.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1419__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1420_o
	// \src: top.v:9326.8-9326.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1424_o
	// \src: top.v:9329.8-9329.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5505_o
	// \src: top.v:2055.8-2055.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5505__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1428_o
	// \src: top.v:9332.8-9332.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5503_o
	// \src: top.v:2053.14-2053.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5503__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1432_o
	// \src: top.v:9335.8-9335.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o;
	// \hdlname: unity_link_inst core_inst hold
	// \src: top.v:12293.8-12293.12
	value<1> p_unity__link__inst_2e_core__inst_2e_hold;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5501_o
	// \src: top.v:2051.14-2051.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5501__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5497_o
	// \src: top.v:2050.8-2050.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5497__o;
	// \hdlname: unity_link_inst core_inst fifo_out_ready
	// \src: top.v:12280.8-12280.22
	value<1> p_unity__link__inst_2e_core__inst_2e_fifo__out__ready;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4695_o
	// \src: top.v:4436.8-4436.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4695__o;
	// \src: top.v:9083.3-9085.41
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_9085_24_2692__EN_5b_31_3a_0_5d__24_2698_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1443_o
	// \src: top.v:9344.8-9344.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1445_o
	// \src: top.v:9345.8-9345.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1446_o
	// \src: top.v:9346.8-9346.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n452_o
	// \src: top.v:11056.14-11056.20
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n452__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3048_o
	// \src: top.v:7159.15-7159.22
	value<14> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3048__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n466_o
	// \src: top.v:11066.14-11066.20
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n466__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n459_o
	// \src: top.v:11061.14-11061.20
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n459__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n473_o
	// \src: top.v:11071.14-11071.20
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n473__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5476_o
	// \src: top.v:2043.8-2043.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5476__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n480_o
	// \src: top.v:11076.14-11076.20
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n480__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n487_o
	// \src: top.v:11081.14-11081.20
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n487__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5471_o
	// \src: top.v:2041.8-2041.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5471__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n494_o
	// \src: top.v:11086.14-11086.20
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n494__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2585_o
	// \src: top.v:6873.8-6873.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2585__o;
	// \src: top.v:12160.3-12162.35
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_12162_24_3194__EN_5b_8_3a_0_5d__24_3245_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5464_o
	// \src: top.v:2039.8-2039.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5464__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2580_o
	// \src: top.v:6869.14-6869.21
	value<2> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2580__o_5b_1_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2556_o
	// \src: top.v:6859.14-6859.21
	value<3> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2556__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5462_o
	// \src: top.v:2038.14-2038.21
	value<5> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5462__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2651_o
	// \src: top.v:6910.14-6910.21
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2651__o_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1478_o
	// \src: top.v:9372.15-9372.22
	value<11> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1478__o;
	// \src: top.v:6626.3-6628.37
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_6628_24_2212__EN_5b_31_3a_0_5d__24_2238_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1482_o
	// \src: top.v:9374.8-9374.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1482__o;
	// \src: top.v:660.3-662.44
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_counters_24_top_2e_v_3a_662_24_34__EN_5b_15_3a_0_5d__24_174_5b_0_5d_;
	// \src: top.v:691.3-693.40
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_losses_24_top_2e_v_3a_693_24_51__EN_5b_7_3a_0_5d__24_185_5b_0_5d_;
	// \src: top.v:5981.3-5983.41
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_last_24_top_2e_v_3a_5983_24_1590__EN_5b_31_3a_0_5d__24_2038_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5449_o
	// \src: top.v:2034.8-2034.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5449__o;
	// \src: top.v:5971.3-5973.37
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_list_24_top_2e_v_3a_5973_24_1589__EN_5b_7_3a_0_5d__24_2029_5b_0_5d_;
	// \src: top.v:5961.3-5963.41
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_state__memory_24_top_2e_v_3a_5963_24_1588__EN_5b_9_3a_0_5d__24_2020_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5440_o
	// \src: top.v:2032.8-2032.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5440__o;
	// \src: top.v:5933.3-5935.42
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5935_24_1571__EN_5b_13_3a_0_5d__24_2011_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2559_o
	// \src: top.v:6860.8-6860.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2559__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n6348_o
	// \src: top.v:1372.14-1372.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6348__o_5b_2_3a_0_5d_;
	// \src: top.v:3867.3-3869.37
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_3869_24_1525__EN_5b_31_3a_0_5d__24_1551_5b_0_5d_;
	// \src: top.v:11410.19-11410.34
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$xor$top.v:11410$3062
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n444__o = xor_uu<8>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<25,18>().val(), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<7,0>().val());
	// \src: top.v:1477.20-1477.66
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$eq$top.v:1477$395
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6200__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<4,3>().val(), value<1>{0x1u});
	// \src: top.v:7895.20-7895.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7895$2413
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<3,0>().val(), value<4>{0xcu});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11420$3064 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4539
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n452__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n444__o.slice<7>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n444__o.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n444__o.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$4277 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$4278_CMP0 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$eq$top.v:1475$394
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6204__o_5b_6_3a_0_5d_ = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6200__o.concat(logic_not<1>(value<29>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<4,3>()).val())).val(), value<1>{0x1u}) ? value<7>{0x5au} : value<7>{0x30u});
	// \src: top.v:7905.20-7905.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7905$2416
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<3,0>().val(), value<4>{0xfu});
	// \src: top.v:9839.20-9839.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9839$2734
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1067__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<11,8>().val());
	// \src: top.v:1490.20-1490.37
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$xor$top.v:1490$397
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6217__o = xor_uu<8>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<12,5>().val(), p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6204__o_5b_6_3a_0_5d_);
	// \src: top.v:1598.20-1598.37
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$xor$top.v:1598$421
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6305__o = xor_uu<8>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<12,5>().val(), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<87,80>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9833$2732 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9831$2731 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:9829$2730 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9825$2728
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<3>().val() ? (or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<2>().val()), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o) ? value<4>{0x5u} : value<4>{0xau}) : value<4>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11430$3066 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4541
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n459__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n444__o.slice<6>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n452__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n452__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9835$2733 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:9813$2724
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<5>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o) ? value<4>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o);
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1500$399 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4571
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6225__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6217__o.slice<7>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6217__o.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6217__o.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1608$423 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4587
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6313__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6305__o.slice<7>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6305__o.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6305__o.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:9841.20-9841.47
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9841$2735
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1067__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<11,8>().val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$or$top.v:11596$3106 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:11594$3105 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:11592$3104
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n632__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<15,12>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<15,12>().val(), value<3>{0x6u}));
	// \src: top.v:11578.19-11578.36
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:11578$3099
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n612__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<15,12>().val(), value<2>{0x3u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11440$3068 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4543
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n466__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n444__o.slice<5>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n459__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n459__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:7814.20-7814.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7814$2377
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1698__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<3,0>().val(), value<3>{0x7u});
	// \src: top.v:7812.20-7812.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7812$2376
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1695__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<3,0>().val(), value<3>{0x4u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4738$1605 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:4736$1604
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o = and_uu<16>(or_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__trigger.curr), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9766$2711 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9764$2710 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9762$2709 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ge$top.v:9756$2707 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$le$top.v:9760$2708 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9752$2706 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9750$2705 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9746$2704 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9742$2703
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter = and_uu<1>(and_uu<1>(and_uu<1>((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1067__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<52>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<53>().val())), (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x1au}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<3>{0x7u})) ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1510$401 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4573
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6232__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6217__o.slice<6>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6225__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6225__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1618$425 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4589
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6320__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6305__o.slice<6>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6313__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6313__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:10822.20-10822.41
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10822$2995
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1945__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<16>().val() ? value<1>{0u} : value<1>{0x1u});
	// \src: top.v:7816.20-7816.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7816$2378
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1699__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1695__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1698__o);
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11450$3070 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4545
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n473__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n444__o.slice<4>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n466__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n466__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:10882.20-10882.37
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10882$3016
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2003__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1945__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1699__o);
	// \src: top.v:10565.20-10565.43
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10565$2909
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<113,105>().val());
	// \src: top.v:7801.20-7801.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7801$2371
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1530__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<3,0>().val());
	// \src: top.v:7778.20-7778.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7778$2360
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1526__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<3,0>().val(), value<2>{0x2u});
	// \src: top.v:7776.20-7776.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7776$2359
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1524__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<3,0>().val(), value<1>{0x1u});
	// \src: top.v:7464.20-7464.38
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7464$2250
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2226__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<19,16>().val(), value<2>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$or$top.v:11656$3123 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:11654$3122 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:11652$3121
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n698__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<7,4>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<7,4>().val(), value<3>{0x6u}));
	// \src: top.v:11638.19-11638.36
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:11638$3116
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n678__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<7,4>().val(), value<2>{0x3u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1520$403 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4575
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6239__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6217__o.slice<5>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6232__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6232__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1628$427 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4591
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6327__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6305__o.slice<5>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6320__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6320__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:7803.20-7803.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7803$2372
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1800__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<3,0>().val(), value<2>{0x3u});
	// \src: top.v:10824.20-10824.41
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10824$2996
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1951__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<16>().val() ? value<1>{0u} : value<1>{0u});
	// \src: top.v:10243.20-10243.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10243$2833
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<4>{0x9u});
	// \src: top.v:10207.20-10207.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10207$2825
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1419__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<4>{0x8u});
	// \src: top.v:7780.20-7780.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7780$2361
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1524__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1526__o);
	// \src: top.v:7452.20-7452.38
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7452$2246
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2211__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<19,16>().val(), value<3>{0x5u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7512$2269 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:7510$2268
	p_unity__link__inst_2e_core__inst_2e_hold = (reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val()) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11460$3072 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4547
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n480__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n444__o.slice<3>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n473__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n473__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10846$3003 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10842$3002 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10836$3000
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1970__o = or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1067__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<114>().val()), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<113>().val());
	// \src: top.v:10448.20-10448.37
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10448$2881
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1419__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o);
	// \src: top.v:10241.20-10241.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10241$2832
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x4u});
	// \src: top.v:10227.20-10227.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10227$2829
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x7u});
	// \src: top.v:10221.20-10221.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10221$2828
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x6u});
	// \src: top.v:10215.20-10215.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10215$2827
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x5u});
	// \src: top.v:10199.20-10199.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10199$2823
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<2>{0x2u});
	// \src: top.v:10193.20-10193.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10193$2822
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<1>{0x1u});
	// \src: top.v:7831.20-7831.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7831$2385
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<3,0>().val(), value<4>{0x8u});
	// \src: top.v:2467.20-2467.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2467$749
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5115__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<2,0>().val(), value<2>{0x3u});
	// \src: top.v:2453.20-2453.40
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2453$744
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5099__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<77,72>().val());
	// \src: top.v:7846.20-7846.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7846$2392
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1850__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<3,0>().val(), value<4>{0xau});
	// \src: top.v:7839.20-7839.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7839$2389
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1848__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<3,0>().val(), value<4>{0x9u});
	// \src: top.v:7772.20-7772.54
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7772$2357
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2559__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<133>().val() ? value<1>{0u} : value<1>{0x1u});
	// \src: top.v:7456.20-7456.38
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7456$2247
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2214__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<19,16>().val(), value<3>{0x6u});
	// \src: top.v:9941.20-9941.28
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9941$2771
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1166__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<125>().val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1530$405 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4577
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6246__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6217__o.slice<4>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6239__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6239__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1638$429 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4593
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6334__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6305__o.slice<4>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6327__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6327__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:7820.20-7820.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7820$2380
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1791__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<3,0>().val(), value<3>{0x5u});
	// \src: top.v:10670.20-10670.64
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ge$top.v:10670$2945
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1804__o = ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<48,41>().val(), value<5>{0x10u});
	// \src: top.v:9885.20-9885.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9885$2752
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1131__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o, value<3>{0x7u});
	// \src: top.v:9883.20-9883.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9883$2751
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1128__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o, value<3>{0x4u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:9881$2750 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9879$2749 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9877$2748
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1125__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o, value<2>{0x2u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o, value<4>{0x9u}));
	// \src: top.v:9875.20-9875.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9875$2747
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1119__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o, value<1>{0x1u});
	// \src: top.v:2477.20-2477.28
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2477$752
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5121__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<10>().val());
	// \src: top.v:2449.20-2449.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2449$743
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5096__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<2,0>().val(), value<3>{0x5u});
	// \src: top.v:7822.20-7822.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7822$2381
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1794__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<3,0>().val(), value<3>{0x6u});
	// \src: top.v:1447.20-1447.37
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$eq$top.v:1447$388
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6154__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<2,0>().val(), value<1>{0x1u});
	// \src: top.v:4906.20-4906.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4906$1657
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3828__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4877__q.curr);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9923$2764 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9921$2763 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:9913$2760 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9911$2759 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9909$2758 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:9907$2757 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9905$2756
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1157__o = not_u<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_hold, or_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<55>().val(), and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter), (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u})))));
	// \src: top.v:9917.20-9917.28
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9917$2761
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1154__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<126>().val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11470$3074 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4549
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n487__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n444__o.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n480__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n480__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:10828.20-10828.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10828$2998
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1959__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<4>{0xau});
	// \src: top.v:10245.20-10245.37
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10245$2834
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10209$2826 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10205$2824
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<2>{0x3u}), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1419__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3307 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3308_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3309_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3310_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3311_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3312_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3313_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3314_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10404$2859 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10424$2869 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10420$2867 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10416$2865 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10422$2868 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10418$2866 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10436$2875
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<1>{0x1u}) ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o ? value<4>{0xau} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<2>{0x2u}) ? ((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1530__o ? value<1>{0u} : value<1>{0x1u})) ? value<4>{0x4u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o ? value<4>{0x3u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1530__o ? value<4>{0xau} : value<4>{0u}))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<3>{0x4u}) ? value<4>{0x4u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<4>{0x8u}) ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o ? value<4>{0x6u} : value<4>{0xau}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<5>{0x10u}) ? value<4>{0x7u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<6>{0x20u}) ? value<4>{0x8u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<7>{0x40u}) ? value<4>{0x9u} : value<4>{0xau})))))));
	// \src: top.v:5161.20-5161.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5161$1744
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4174__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4877__q.curr, value<3>{0x4u});
	// \src: top.v:2493.20-2493.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2493$758
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5138__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<2,0>().val(), value<3>{0x4u});
	// \src: top.v:2483.20-2483.43
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:2483$754
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5125__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<39,31>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7888$2411 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7886$2410 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7884$2409
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1854__o = or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1848__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1850__o), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<3,0>().val(), value<4>{0xbu}));
	// \src: top.v:7824.20-7824.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7824$2382
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1904__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1791__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1794__o);
	// \src: top.v:7805.20-7805.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7805$2373
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1892__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1530__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1800__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7797$2369 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7793$2367 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7787$2364
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2585__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2559__o, logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.curr)), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2559__o);
	// \src: top.v:7770.20-7770.60
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7770$2356
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2556__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<133>().val() ? value<3>{0x6u} : value<3>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$or$top.v:1443$387 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$not$top.v:1441$386
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_advance = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<25>().val()), p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_out__ready.curr);
	// \src: top.v:7546.20-7546.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7546$2282
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2316__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val(), value<3>{0x7u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1540$407 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4579
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6253__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6217__o.slice<3>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6246__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6246__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1648$431 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4595
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6341__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6305__o.slice<3>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6334__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6334__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:10617.20-10617.42
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10617$2924
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1757__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<40,33>().val());
	// \full_case: 1
	// \src: top.v:10354.19-10354.19|top.v:10354.5-10363.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3323_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3323__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<7>{0x40u});
	// \src: top.v:10063.20-10063.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10063$2795
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<4>{0xdu});
	// \src: top.v:10028.20-10028.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10028$2788
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x11u});
	// \src: top.v:10086.20-10086.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10086$2801
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x13u});
	// \src: top.v:10030.20-10030.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10030$2789
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<4>{0xbu});
	// \src: top.v:10119.20-10119.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10119$2810
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1351__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x10u});
	// \src: top.v:10117.20-10117.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10117$2809
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1348__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x18u});
	// \src: top.v:10115.20-10115.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10115$2808
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1345__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<4>{0xeu});
	// \src: top.v:10034.20-10034.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10034$2791
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<3>{0x7u});
	// \src: top.v:10032.20-10032.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10032$2790
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<4>{0x9u});
	// \src: top.v:10026.20-10026.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10026$2787
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<4>{0x8u});
	// \src: top.v:10024.20-10024.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10024$2786
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x17u});
	// \src: top.v:10022.20-10022.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10022$2785
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x12u});
	// \src: top.v:6239.20-6239.34
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:6239$2115
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3458__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3641__q.curr);
	// \src: top.v:5163.20-5163.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5163$1745
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4174__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:7914.38-7914.38|top.v:7910.5-7920.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3783_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3663__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1854__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1904__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1699__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1892__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<4>{0x8u});
	// \src: top.v:8416.20-8416.47
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8416$2564
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3025__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<133>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<13,3>().concat(value<3>{0x7u}).val() : value<3>{0x4u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<24,17>()).concat(value<3>{0x6u}).val());
	// \full_case: 1
	// \src: top.v:7913.38-7913.38|top.v:7910.5-7920.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3784_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3621__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1854__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1904__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1699__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1892__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:7917.38-7917.38|top.v:7910.5-7920.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3780_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3660__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1854__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1904__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1699__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1892__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:7912.38-7912.38|top.v:7910.5-7920.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3785_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3614__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1854__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1904__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1699__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1892__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:7916.38-7916.38|top.v:7910.5-7920.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3781_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3627__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1854__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1904__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1699__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1892__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<2>{0x2u});
	// \src: top.v:7866.20-7866.47
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7866$2401
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2651__o_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_group__is__set.curr ? value<1>{0u} : value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:7915.38-7915.38|top.v:7910.5-7920.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3782_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3628__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1854__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1904__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1699__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1892__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<3>{0x4u});
	// \src: top.v:7789.20-7789.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7789$2365
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2580__o_5b_1_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2585__o ? value<2>{0x1u} : value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:7910.19-7910.19|top.v:7910.5-7920.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3786_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3623__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1854__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1904__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1699__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1892__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<8>{0x80u});
	// \full_case: 1
	// \src: top.v:8457.38-8457.38|top.v:8456.5-8466.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3646_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3646__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1854__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1904__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1699__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1892__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<7>{0x40u});
	// \src: top.v:2615.20-2615.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2615$793
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5292__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<6,3>().val(), value<3>{0x5u});
	// \src: top.v:2381.20-2381.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2381$722
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5038__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<2,0>().val());
	// \src: top.v:7548.20-7548.41
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7548$2283
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2323__o = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2316__o ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4910$1659 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4908$1658
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3836__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4887__q.curr, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3828__o ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:11736$3143 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$not$top.v:11730$3141 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$not$top.v:11734$3142
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n775__o = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<45>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<44>().val()));
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11480$3076 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4551
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n494__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n452__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n487__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n487__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9901$2755 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3440 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3441_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3442_CMP0
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1067__o ? value<1>{0u}.concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1131__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1128__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1125__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1119__o).val(), value<3>{0x4u}) ? value<3>{0x7u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1131__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1128__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1125__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1119__o).val(), value<4>{0x8u}) ? value<3>{0x3u} : value<3>{0x1u}))).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<15,12>().val());
	// \src: top.v:10477.20-10477.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10477$2888
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1624__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o, value<3>{0x7u});
	// \src: top.v:10475.20-10475.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10475$2887
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1621__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o, value<3>{0x4u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10473$2886 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10471$2885 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10469$2884
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1618__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o, value<2>{0x2u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o, value<4>{0x9u}));
	// \src: top.v:10467.20-10467.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10467$2883
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1612__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o, value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10076.19-10076.19|top.v:10076.5-10080.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3414_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3414__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10077.33-10077.33|top.v:10076.5-10080.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3413_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3413__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10103.19-10103.19|top.v:10103.5-10109.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3404_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3404__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10104.35-10104.35|top.v:10103.5-10109.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3403_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3403__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10105.35-10105.35|top.v:10103.5-10109.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3402_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3402__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10106.35-10106.35|top.v:10103.5-10109.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3401_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3401__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10132.19-10132.19|top.v:10132.5-10138.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3392_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3392__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1351__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10133.35-10133.35|top.v:10132.5-10138.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3391_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3391__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1351__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10134.35-10134.35|top.v:10132.5-10138.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3390_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3390__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1351__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10135.35-10135.35|top.v:10132.5-10138.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3389_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3389__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1351__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10056.38-10056.38|top.v:10050.5-10059.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3421_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3421__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10043.34-10043.34|top.v:10038.5-10047.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3431_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3422__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10042.34-10042.34|top.v:10038.5-10047.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3432_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3423__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10041.34-10041.34|top.v:10038.5-10047.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3433_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3424__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10040.34-10040.34|top.v:10038.5-10047.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3434_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3425__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:10039.34-10039.34|top.v:10038.5-10047.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3435_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3426__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:10038.19-10038.19|top.v:10038.5-10047.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3436_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3427__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<7>{0x40u});
	// \src: top.v:6241.20-6241.41
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6241$2116
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3465__o = (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3458__o ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6237$2114 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6245$2118
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3455__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample, not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr));
	// \src: top.v:5195.20-5195.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5195$1760
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4223__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4877__q.curr, value<2>{0x3u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5219$1769 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5215$1768 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5223$1770
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4250__o = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4881__q.curr.slice<3>().val() ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4881__q.curr.slice<13,6>().val(), value<2>{0x2u}) : add_uu<9>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4881__q.curr.slice<13,6>().val(), value<1>{0x1u}));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7442$2244 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7438$2242
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<19,16>().val(), value<2>{0x3u}) ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:8547.20-8547.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8547$2584
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3068__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1526__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1800__o);
	// \src: top.v:8541.20-8541.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8541$2581
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3059__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1530__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1524__o);
	// \src: top.v:2619.20-2619.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2619$795
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5295__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<6,3>().val(), value<3>{0x6u});
	// \src: top.v:2607.20-2607.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2607$789
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5280__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<6,3>().val(), value<2>{0x2u});
	// \src: top.v:2603.20-2603.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2603$787
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5277__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<6,3>().val(), value<1>{0x1u});
	// \src: top.v:2752.20-2752.43
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2752$839
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5497__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<39,31>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7586$2294 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:7584$2293
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2369__o = (reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<73,70>().val()) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2377$721 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$and$top.v:1451$390 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1449$389 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2375$720
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<88>().val()), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_advance, (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6154__o ? value<1>{0x1u} : value<1>{0u})));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7598$2298 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7596$2297
	p_unity__link__inst_2e_core__inst_2e_answer__valid = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2323__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<22>().val()));
	// \full_case: 1
	// \src: top.v:734.32-734.32|top.v:731.5-736.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4361_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4296__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<1,0>().val(), value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:733.32-733.32|top.v:731.5-736.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4362_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4297__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<1,0>().val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:732.32-732.32|top.v:731.5-736.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4363_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4298__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<1,0>().val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:731.19-731.19|top.v:731.5-736.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4364_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4299__CMP = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<1,0>().val());
	// \src: top.v:4912.20-4912.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4912$1660
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3838__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3836__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4889__q.curr);
	// \src: top.v:4948.20-4948.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4948$1675
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3881__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.curr, value<4>{0x8u});
	// \src: top.v:4914.20-4914.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4914$1661
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3845__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.curr, value<4>{0xfu});
	// \src: top.v:4943.20-4943.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4943$1673
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3876__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.curr, value<4>{0x9u});
	// \src: top.v:4973.20-4973.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4973$1685
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3906__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.curr, value<2>{0x3u});
	// \src: top.v:4938.20-4938.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4938$1671
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3871__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.curr, value<4>{0xau});
	// \src: top.v:4968.20-4968.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4968$1683
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3901__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.curr, value<3>{0x4u});
	// \src: top.v:4933.20-4933.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4933$1669
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3866__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.curr, value<4>{0xbu});
	// \src: top.v:4963.20-4963.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4963$1681
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3896__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.curr, value<3>{0x5u});
	// \src: top.v:4928.20-4928.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4928$1667
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3861__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.curr, value<4>{0xcu});
	// \src: top.v:4958.20-4958.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4958$1679
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3891__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.curr, value<3>{0x6u});
	// \src: top.v:4989.20-4989.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4989$1691
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3921__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.curr);
	// \src: top.v:4923.20-4923.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4923$1665
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3856__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.curr, value<4>{0xdu});
	// \src: top.v:4983.20-4983.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4983$1689
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3916__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.curr, value<1>{0x1u});
	// \src: top.v:4953.20-4953.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4953$1677
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3886__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.curr, value<3>{0x7u});
	// \src: top.v:4978.20-4978.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4978$1687
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3911__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.curr, value<2>{0x2u});
	// \src: top.v:4918.20-4918.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4918$1663
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3851__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.curr, value<4>{0xeu});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$or$top.v:11353$3054 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9947$2774 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9945$2773 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9943$2772 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9937$2770 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9935$2769 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$not$top.v:11351$3053
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_advance = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<54>().val()), and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1154__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1157__o), not_u<1>(and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<55>().val(), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<56>().val()), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1166__o))));
	// \src: top.v:11536.19-11536.35
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$or$top.v:11536$3087
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n535__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<39>().val(), p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<8>().val());
	// \src: top.v:11854.19-11854.45
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:11854$3166
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n875__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<37,26>().val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1550$409 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4581
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6260__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6217__o.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6253__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6253__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1658$433 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4597
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6348__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6305__o.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6341__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6341__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10666$2944 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10662$2942 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10658$2940 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10654$2938
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1801__o = or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1695__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1791__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1794__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1698__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1800__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10187$2821 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$add$top.v:10183$2820
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<52>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<49,46>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<49,46>().val());
	// \src: top.v:10378.20-10378.35
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10378$2849
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1482__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left);
	// \src: top.v:10503.20-10503.42
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$add$top.v:10503$2894
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1643__o = add_uu<9>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<113,105>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10374$2847 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10369$2846 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3322
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1478__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o) ? value<11>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<115>().concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3323__CMP ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<114>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<113,105>()).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:9796$2721 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9794$2720 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9792$2719
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1019__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<53,50>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<53,50>().val(), value<3>{0x6u}));
	// \src: top.v:9778.19-9778.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9778$2714
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n999__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<53,50>().val(), value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:10269.37-10269.37|top.v:10263.5-10272.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3365_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3365__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10281.37-10281.37|top.v:10276.5-10285.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3362_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3362__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10293.37-10293.37|top.v:10289.5-10298.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3358_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3358__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10305.37-10305.37|top.v:10302.5-10311.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3353_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3353__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10317.37-10317.37|top.v:10315.5-10324.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3347_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3347__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:10329.37-10329.37|top.v:10328.5-10337.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3340_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3340__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<6>{0x20u});
	// \src: top.v:10140.20-10140.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10140$2813
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1367__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<4,0>().val(), value<5>{0x11u});
	// \src: top.v:10111.20-10111.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10111$2806
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1339__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<4,0>().val(), value<3>{0x4u});
	// \src: top.v:10082.20-10082.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10082$2799
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1309__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<4,0>().val());
	// \src: top.v:10061.20-10061.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10061$2794
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1290__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<4,0>().val(), value<5>{0x10u});
	// \src: top.v:5177.20-5177.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5177$1751
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4190__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4878__q.curr, value<2>{0x2u});
	// \src: top.v:6243.20-6243.37
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6243$2117
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3455__o, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3465__o);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5153$1741 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5151$1740 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5149$1739
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4161__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4881__q.curr.slice<1>().val(), (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4878__q.curr, value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u}));
	// \src: top.v:6263.20-6263.34
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:6263$2127
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3486__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3641__q.curr, value<2>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7484$2257 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7482$2256
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2251__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked, not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<57>().val()));
	// \full_case: 1
	// \src: top.v:8601.33-8601.33|top.v:8599.5-8604.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3588_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3588__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1698__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3068__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3059__o).val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8525$2574 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3659 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3656 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3645
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3048__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<133>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<13,3>().concat(value<3>{0x7u}).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3646__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<42,41>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3623__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3025__o.slice<13,12>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<13,12>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3623__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3025__o.slice<11,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<11,3>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3660__CMP ? value<3>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3627__CMP ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2580__o_5b_1_3a_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3628__CMP ? value<3>{0x3u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3663__CMP ? value<3>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3621__CMP ? value<3>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3614__CMP ? value<2>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2651__o_5b_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3623__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3025__o.slice<2,0>().val() : value<3>{0x7u})))))))).val());
	// \src: top.v:8025.20-8025.41
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$add$top.v:8025$2429
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2716__o = add_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<10,3>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8017$2427 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3620 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7869$2402 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7864$2400 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7860$2398
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2711__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<133>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<60,58>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3621__CMP ? value<3>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3614__CMP ? (p_unity__link__inst_2e_core__inst_2e_group__is__set.curr ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1848__o ? value<3>{0x1u} : value<2>{0x1u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1850__o ? value<1>{0u} : value<1>{0x1u})).val()) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<60,58>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3623__CMP ? value<3>{0x4u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<60,58>().val()))));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8014$2426 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3626 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7791$2366
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2709__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<133>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<56>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3627__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2585__o ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3628__CMP ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<56>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8019$2428 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3613 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7837$2388 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7878$2406 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7871$2403 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7833$2386
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2712__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<133>().val() ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2556__o_5b_2_3a_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3614__CMP ? (and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2559__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_group__is__set.curr)), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2559__o) ? value<4>{0x6u} : value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2556__o_5b_2_3a_0_5d_).val()) : value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2556__o_5b_2_3a_0_5d_).val()));
	// \src: top.v:2711.20-2711.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2711$831
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5449__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<6,3>().val(), value<4>{0xbu});
	// \src: top.v:2707.20-2707.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2707$829
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5440__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<6,3>().val(), value<4>{0xau});
	// \src: top.v:2703.20-2703.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2703$827
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5431__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<6,3>().val(), value<4>{0x9u});
	// \src: top.v:2699.20-2699.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2699$825
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5422__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<6,3>().val(), value<4>{0x8u});
	// \src: top.v:2691.20-2691.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2691$821
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5404__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5280__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5295__o);
	// \src: top.v:2683.20-2683.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2683$817
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5392__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5277__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5292__o);
	// \src: top.v:2627.20-2627.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2627$799
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5301__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<6,3>().val(), value<2>{0x3u});
	// \src: top.v:2754.20-2754.45
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2754$840
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5501__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5497__o ? value<3>{0u} : value<3>{0x5u});
	// \src: top.v:2762.20-2762.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2762$844
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5505__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5497__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5121__o);
	// \src: top.v:7616.20-7616.28
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7616$2300
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2395__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2369__o);
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2385$724 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2383$723
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5046__o = and_uu<1>((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5038__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance);
	// \full_case: 1
	// \src: top.v:774.32-774.32|top.v:771.5-776.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4341_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4291__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<3,2>().val(), value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:773.32-773.32|top.v:771.5-776.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4342_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4292__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<3,2>().val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:772.32-772.32|top.v:771.5-776.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4343_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4293__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<3,2>().val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:771.19-771.19|top.v:771.5-776.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4344_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4294__CMP = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<3,2>().val());
	// \src: top.v:4994.20-4994.28
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4994$1693
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3924__o = not_u<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr);
	// \src: top.v:11540.19-11540.41
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:11540$3089
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n544__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<7,0>().val(), value<4>{0xdu});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10766$2978 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10762$2976
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1898__o = or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1892__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1695__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1698__o);
	// \full_case: 1
	// \src: top.v:10153.19-10153.19|top.v:10153.5-10159.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3380_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3380__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1367__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1339__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1309__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1290__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10154.34-10154.34|top.v:10153.5-10159.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3379_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3379__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1367__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1339__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1309__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1290__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10155.34-10155.34|top.v:10153.5-10159.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3378_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3378__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1367__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1339__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1309__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1290__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10156.34-10156.34|top.v:10153.5-10159.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3377_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3377__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1367__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1339__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1309__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1290__o).val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5159$1743 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ge$top.v:5157$1742
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room = (ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__ring__room.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4250__o) ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:6265.20-6265.41
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6265$2128
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3493__o = (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3486__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:8567.33-8567.33|top.v:8565.5-8570.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3601
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3078__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3588__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3048__o.slice<13,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<13,3>().val());
	// \full_case: 1
	// \src: top.v:8200.38-8200.38|top.v:8199.5-8209.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3705
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2696__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3646__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<42,41>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3623__CMP ? value<2>{0x2u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<13,12>().val()));
	// \full_case: 1
	// \src: top.v:7917.38-7917.38|top.v:7910.5-7920.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3779
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2690__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3660__CMP ? value<3>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3627__CMP ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2580__o_5b_1_3a_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3628__CMP ? value<3>{0x3u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3663__CMP ? value<3>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3621__CMP ? value<3>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3614__CMP ? value<2>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2651__o_5b_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3623__CMP ? value<3>{0x6u} : value<3>{0x7u})))))));
	// \src: top.v:2760.20-2760.51
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2760$843
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5504__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<10>().val() ? value<3>{0x1u} : value<3>{0x7u});
	// \src: top.v:2922.20-2922.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2922$902
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5710__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<2,0>().val(), value<3>{0x6u});
	// \src: top.v:2758.20-2758.46
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2758$842
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5503__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<10>().val() ? value<3>{0x4u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5501__o);
	// \src: top.v:5421.20-5421.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5421$1848
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4514__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<60,58>().val(), value<2>{0x2u});
	// \src: top.v:5333.20-5333.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5333$1813
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4407__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<60,58>().val(), value<3>{0x4u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:4996$1694 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4991$1692 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4986$1690 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4981$1688 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4976$1686 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4971$1684 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4966$1682 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4961$1680 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4956$1678 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4951$1676 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4946$1674 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4941$1672 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4936$1670 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4931$1668 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4926$1666 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4921$1664 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4916$1662
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer = or_uu<16>((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3845__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3838__o : value<1>{0u}).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3851__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3838__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3856__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3838__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3861__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3838__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3866__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3838__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3871__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3838__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3876__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3838__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3881__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3838__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3886__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3838__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3891__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3838__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3896__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3838__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3901__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3838__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3906__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3838__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3911__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3838__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3916__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3838__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3921__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3838__o : value<1>{0u})).val(), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3924__o);
	// \src: top.v:12059.19-12059.38
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12059$3195
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o = and_uu<1>(p_in__valid, p_in__ready.curr);
	// cells $flatten\unity_link_inst.\core_inst.\rx_register_inst.$or$top.v:11947$3185 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:11359$3056 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$not$top.v:11357$3055 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$not$top.v:11949$3186
	p_unity__link__inst_2e_core__inst_2e_fifo__out__ready = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_character__valid.curr), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_advance, not_u<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<41>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:11556$3093 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$not$top.v:11550$3091 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:11554$3092
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n559__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<37,26>().val(), value<12>{0x800u}), not_u<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n535__o));
	// \src: top.v:11495.19-11495.39
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11495$3080
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n504__o = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<16>().val() ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11493$3079 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11490$3078 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4553
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n503__o = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<16>().val() ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n466__o_5b_2_3a_0_5d_.slice<2>().concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n473__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n480__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n487__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n494__o_5b_2_3a_0_5d_.slice<2>()).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n459__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n494__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n494__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val())).val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<25,18>().val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1560$411 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4583
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6267__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6225__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6260__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6260__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1668$435 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4599
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6355__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6313__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6348__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6348__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10579$2914 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10567$2910 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10561$2908 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10557$2907
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1700__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1699__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<114>().val(), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<11,8>().val(), value<3>{0x4u}))));
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3444 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3445_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3446_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9776$2713 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$le$top.v:9774$2712 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9790$2718 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9788$2717 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ge$top.v:9782$2715 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$le$top.v:9786$2716
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1019__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n999__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<49,46>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1019__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n999__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<49,46>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<49,46>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u}));
	// \src: top.v:10553.20-10553.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10553$2906
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1682__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1166__o, p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<56>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5211$1767 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5207$1766 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5205$1765 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5203$1764
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4245__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample, (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr) ? value<1>{0x1u} : value<1>{0u})), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4881__q.curr.slice<3>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5201$1763 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5199$1762 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5197$1761
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4232__o = and_uu<1>(and_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4223__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4161__o), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room);
	// \src: top.v:6267.20-6267.40
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6267$2129
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3494__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3493__o, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr);
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2511$765 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2509$764 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2507$763 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2505$762 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2499$760 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2489$757 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2487$756 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2485$755 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2479$753 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2473$751 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2463$748 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2461$747 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2455$745 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:2459$746
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance, or_uu<1>(or_uu<1>((and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<39,31>().val(), value<1>{0x1u}), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5099__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5096__o)) ? value<1>{0x1u} : value<1>{0u}), (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5125__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5121__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5099__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5115__o))) ? value<1>{0x1u} : value<1>{0u})), (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5125__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5099__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5138__o)) ? value<1>{0x1u} : value<1>{0u})));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7488$2259 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7486$2258 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7478$2255 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7476$2254
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word = and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<46,39>().val(), value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u}), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2251__o));
	// \src: top.v:5492.20-5492.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5492$1878
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3559__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_access__failure.curr);
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7472$2253 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7470$2252
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2226__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2214__o) ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:7448.20-7448.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7448$2245
	p_unity__link__inst_2e_core__inst_2e_access__write = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<18>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<57>().val());
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6275$2133 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6273$2132
	p_unity__link__inst_2e_core__inst_2e_access__done = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3493__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr));
	// \src: top.v:1140.20-1140.39
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1140$332
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6455__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<25>().val(), p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_out__ready.curr);
	// \src: top.v:2738.20-2738.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2738$837
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5476__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<7,3>().val(), value<4>{0xeu});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2609$790 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2605$788 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2601$786
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5281__o = or_uu<1>(or_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<6,3>().val()), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5277__o), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5280__o);
	// \src: top.v:2645.20-2645.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2645$808
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5338__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<6,3>().val(), value<4>{0xfu});
	// \src: top.v:2641.20-2641.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2641$806
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5329__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<6,3>().val(), value<4>{0xeu});
	// \src: top.v:2637.20-2637.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2637$804
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5320__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<6,3>().val(), value<4>{0xdu});
	// \src: top.v:2633.20-2633.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2633$802
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5311__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<6,3>().val(), value<4>{0xcu});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2629$800 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2625$798 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2623$797 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2621$796 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2617$794 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2613$792
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5302__o = or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<6,3>().val(), value<3>{0x4u}), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5292__o), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5295__o), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<6,3>().val(), value<3>{0x7u})), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5301__o);
	// \src: top.v:2582.20-2582.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2582$781
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5252__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<7,3>().val(), value<5>{0x11u});
	// \src: top.v:2580.20-2580.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2580$780
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5248__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<7,3>().val(), value<5>{0x10u});
	// memory \unity_link_inst.core_inst.frame_writer_inst.n6141 read port 0
	auto tmp_0 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<77,72>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_0.valid && "out of bounds read");
	if(tmp_0.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6142__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6141[tmp_0.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6142__data = value<4> {};
	}
	// \full_case: 1
	// \src: top.v:3210.19-3210.19|top.v:3210.5-3215.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4181_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4181__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5710__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5138__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5115__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:3211.36-3211.36|top.v:3210.5-3215.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4180_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4180__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5710__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5138__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5115__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:3212.33-3212.33|top.v:3210.5-3215.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4179_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4179__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5710__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5138__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5115__o).val(), value<1>{0x1u});
	// memory \unity_link_inst.core_inst.frame_writer_inst.n6139 read port 0
	auto tmp_1 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<77,72>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_1.valid && "out of bounds read");
	if(tmp_1.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6140__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6139[tmp_1.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6140__data = value<4> {};
	}
	// memory \unity_link_inst.core_inst.frame_writer_inst.n6137 read port 0
	auto tmp_2 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<77,72>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_2.valid && "out of bounds read");
	if(tmp_2.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6138__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6137[tmp_2.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6138__data = value<4> {};
	}
	// memory \unity_link_inst.core_inst.frame_writer_inst.n6135 read port 0
	auto tmp_3 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<77,72>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_3.valid && "out of bounds read");
	if(tmp_3.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6136__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6135[tmp_3.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6136__data = value<4> {};
	}
	// \src: top.v:2789.20-2789.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2789$857
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5520__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<2,0>().val(), value<1>{0x1u});
	// \src: top.v:2908.20-2908.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2908$899
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5682__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<2,0>().val(), value<2>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2413$735 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2411$734 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2409$733 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2405$732
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5068__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5046__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available.curr), not_u<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<78>().val(), p_unity__link__inst_2e_core__inst_2e_answer__valid)));
	// \src: top.v:5486.20-5486.40
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5486$1875
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4564__o = add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4893__q.curr, value<1>{0x1u});
	// \src: top.v:7570.20-7570.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7570$2290
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val(), value<3>{0x6u});
	// \src: top.v:7566.20-7566.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7566$2289
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2342__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:5432.19-5432.19|top.v:5432.5-5436.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4028_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4028__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4514__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4407__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:5433.32-5433.32|top.v:5432.5-5436.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4027_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4027__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4514__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4407__o).val(), value<1>{0x1u});
	// \src: top.v:5275.20-5275.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5275$1787
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4328__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4877__q.curr, value<3>{0x6u});
	// \src: top.v:12061.19-12061.40
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12061$3196
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr, p_unity__link__inst_2e_core__inst_2e_fifo__out__ready);
	// \src: top.v:12075.19-12075.40
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$eq$top.v:12075$3203
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n276__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11726$3140 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11718$3138 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11700$3134 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11698$3133 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11696$3132 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:11680$3129 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:11666$3125 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:11626$3113 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:11620$3112 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:11606$3108 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$procmux$3281 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$procmux$3282_CMP0 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$procmux$3283_CMP0 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11576$3098 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$le$top.v:11574$3097 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11590$3103 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:11588$3102 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ge$top.v:11582$3100 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$le$top.v:11586$3101 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:11618$3111 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11616$3110 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$add$top.v:11612$3109 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$procmux$3277 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$procmux$3278_CMP0 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$procmux$3279_CMP0 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11636$3115 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$le$top.v:11634$3114 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11650$3120 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:11648$3119 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ge$top.v:11642$3117 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$le$top.v:11646$3118 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:11678$3128 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11676$3127 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$add$top.v:11672$3126
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n767__o = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n559__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<61,56>().concat(value<2>{0u}).val() : (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n544__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<61,56>().concat(value<2>{0u}).val() : value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n535__o ? value<4>{0x9u} : (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<38>().val() ? value<4>{0x7u} : value<3>{0u}.concat((and_uu<1>(eq_uu<1>((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<6>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<3,0>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<3,0>().val()), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<25,22>().val()), and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n698__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n678__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<3,0>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n698__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n678__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<3,0>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<3,0>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<16>().val(), and_uu<1>(eq_uu<1>((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<14>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<11,8>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<11,8>().val()), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<21,18>().val()), and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n632__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n612__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<11,8>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n632__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n612__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<11,8>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<11,8>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<17>().val()))))) ? value<1>{0u} : value<1>{0x1u})).val()))).concat(value<3>{0x3u}).val()));
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$or$top.v:11542$3090 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:11538$3088
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n545__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<7,0>().val(), value<4>{0xau}), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n544__o);
	// \src: top.v:11850.19-11850.43
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11850$3165
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n872__o = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n775__o ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<53,46>()).val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n504__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<7,0>()).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11722$3139 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11707$3135 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11710$3136 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11714$3137
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n764__o = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n559__o ? value<30>{0x10200000u} : (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n544__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<45,42>().val() : value<4>{0x4u}).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n544__o ? value<1>{0x1u} : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n544__o ? value<1>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n535__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<38,16>()).val() : value<25>{0x200000u})).val());
	// \src: top.v:11846.19-11846.43
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11846$3164
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n869__o = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n775__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<25,0>().val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n503__o.concat(value<1>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<17>()).concat(p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<7,0>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<15,8>()).val());
	// \src: top.v:1594.20-1594.37
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$eq$top.v:1594$420
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6291__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<2,0>().val());
	// \src: top.v:1733.20-1733.37
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$eq$top.v:1733$453
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6419__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<2,0>().val(), value<3>{0x4u});
	// \src: top.v:1729.20-1729.37
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$eq$top.v:1729$452
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6410__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<2,0>().val(), value<2>{0x3u});
	// \src: top.v:1727.20-1727.37
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$eq$top.v:1727$451
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6405__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<2,0>().val(), value<2>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5183$1754 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5181$1753 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5179$1752 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5175$1750 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5173$1749 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5169$1748 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5167$1747
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr), or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<8>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4881__q.curr.slice<4>().val())), (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4190__o ? value<1>{0x1u} : value<1>{0u})));
	// \src: top.v:5251.20-5251.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5251$1775
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4291__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4877__q.curr, value<3>{0x5u});
	// \src: top.v:5165.20-5165.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5165$1746
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4182__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3494__o, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample);
	// \src: top.v:5189.20-5189.39
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5189$1757
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4212__o = add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr, value<1>{0x1u});
	// \src: top.v:1142.20-1142.41
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1142$333
	p_unity__link__inst_2e_core__inst_2e_n198__o = and_uu<1>(p_out__valid.curr, p_out__ready);
	// \src: top.v:1186.20-1186.41
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$eq$top.v:1186$355
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6486__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2728$834 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4198 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4199_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4200_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4201_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4202_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4203_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4204_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4205_CMP0
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5462__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<7>().val() ? value<5>{0u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5449__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5440__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5431__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5422__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5301__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5404__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5392__o).val(), value<1>{0x1u}) ? value<5>{0xdu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5449__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5440__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5431__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5422__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5301__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5404__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5392__o).val(), value<2>{0x2u}) ? value<5>{0x11u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5449__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5440__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5431__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5422__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5301__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5404__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5392__o).val(), value<3>{0x4u}) ? value<5>{0xbu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5449__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5440__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5431__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5422__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5301__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5404__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5392__o).val(), value<4>{0x8u}) ? value<5>{0x13u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5449__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5440__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5431__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5422__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5301__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5404__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5392__o).val(), value<5>{0x10u}) ? value<5>{0xeu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5449__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5440__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5431__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5422__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5301__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5404__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5392__o).val(), value<6>{0x20u}) ? value<5>{0x18u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5449__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5440__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5431__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5422__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5301__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5404__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5392__o).val(), value<7>{0x40u}) ? value<5>{0x10u} : value<5>{0u}))))))));
	// \src: top.v:2734.20-2734.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2734$836
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5471__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<7,3>().val(), value<5>{0x12u});
	// \full_case: 1
	// \src: top.v:3212.33-3212.33|top.v:3210.5-3215.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4178
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6013__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4179__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<18,15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4180__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<30,27>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4181__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6142__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<71,68>().val())));
	// \full_case: 1
	// \src: top.v:3112.33-3112.33|top.v:3110.5-3115.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4183
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5909__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4179__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<18,15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4180__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<30,27>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4181__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6140__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<71,68>().val())));
	// \full_case: 1
	// \src: top.v:3026.33-3026.33|top.v:3024.5-3029.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4188
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5816__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4179__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<18,15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4180__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<30,27>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4181__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6138__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<71,68>().val())));
	// \full_case: 1
	// \src: top.v:2930.33-2930.33|top.v:2928.5-2933.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4193
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5713__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4179__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<18,15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4180__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<30,27>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4181__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6136__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<71,68>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7622$2303 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7620$2302 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7618$2301 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7614$2299
	p_unity__link__inst_2e_core__inst_2e_answer__has__id = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<20>().val(), (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2395__o, eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<19,16>().val(), value<4>{0xfu})) ? value<1>{0x1u} : value<1>{0u}));
	// \full_case: 1
	// \src: top.v:3462.37-3462.37|top.v:3458.5-3467.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4046_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4046__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5710__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5096__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5138__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5115__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5682__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5520__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5038__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:3463.37-3463.37|top.v:3458.5-3467.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4045_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4045__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5710__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5096__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5138__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5115__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5682__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5520__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5038__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:3458.19-3458.19|top.v:3458.5-3467.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4050_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4050__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5710__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5096__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5138__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5115__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5682__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5520__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5038__o).val(), value<7>{0x40u});
	// \full_case: 1
	// \src: top.v:3459.37-3459.37|top.v:3458.5-3467.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4049_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4049__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5710__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5096__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5138__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5115__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5682__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5520__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5038__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:3460.37-3460.37|top.v:3458.5-3467.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4048_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4048__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5710__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5096__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5138__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5115__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5682__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5520__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5038__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:3461.37-3461.37|top.v:3458.5-3467.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4047_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4047__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5710__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5096__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5138__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5115__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5682__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5520__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5038__o).val(), value<4>{0x8u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2395$728 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2393$727 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2391$726 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2387$725
	p_unity__link__inst_2e_core__inst_2e_answer__taken = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5046__o, p_unity__link__inst_2e_core__inst_2e_answer__valid), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<78>().val(), not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available.curr)));
	// \src: top.v:2542.20-2542.51
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2542$770
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5214__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5068__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6134__q.curr.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6134__q.curr.slice<15,7>()).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<71,31>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5599$1924 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5597$1923
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4695__o = (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5594$1922 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5591$1921
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4690__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr, value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5589$1920 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5586$1919
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4684__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr, value<2>{0x2u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5584$1918 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5581$1917
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4678__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr, value<2>{0x3u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5579$1916 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5576$1915
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4672__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr, value<3>{0x4u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5574$1914 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5571$1913
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4666__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr, value<3>{0x5u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5569$1912 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5566$1911
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4660__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr, value<3>{0x6u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5564$1910 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5561$1909
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4654__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr, value<3>{0x7u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5559$1908 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5556$1907
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4648__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr, value<4>{0x8u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5554$1906 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5551$1905
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4642__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr, value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5549$1904 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5546$1903
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4636__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr, value<4>{0xau}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5544$1902 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5541$1901
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4630__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr, value<4>{0xbu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5539$1900 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5536$1899
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4624__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr, value<4>{0xcu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5534$1898 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5531$1897
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4618__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr, value<4>{0xdu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5529$1896 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5526$1895
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4612__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr, value<4>{0xeu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5524$1894 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5522$1893
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4605__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr, value<4>{0xfu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5000$1696 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4998$1695
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3836__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4889__q.curr));
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5269$1784 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5267$1783 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5265$1782
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4315__o = (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4878__q.curr) ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<7,0>().val(), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost__kept.curr) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<7,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:331$58 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:329$57 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ne$top.v:327$56 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:325$55 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4340 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4345 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4350 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4355 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4360
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counts = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr, (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4291__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4296__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr.slice<15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4297__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr.slice<14>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4298__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr.slice<13>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4299__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr.slice<12>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4292__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4296__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr.slice<11>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4297__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr.slice<10>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4298__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr.slice<9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4299__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr.slice<8>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4293__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4296__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr.slice<7>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4297__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr.slice<6>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4298__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr.slice<5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4299__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr.slice<4>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4294__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4296__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr.slice<3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4297__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr.slice<2>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4298__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr.slice<1>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4299__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr.slice<0>().val() : value<1>{0u})))) : value<1>{0u}))))), (reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor.curr) ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12101$3216 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$not$top.v:12099$3215
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o));
	// \src: top.v:11383.19-11383.34
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:11383$3058
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n395__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<17,16>().val());
	// \full_case: 1
	// \src: top.v:1809.19-1809.19|top.v:1809.5-1816.12
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$4233_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4233__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6419__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6410__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6405__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6154__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6291__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:1810.32-1810.32|top.v:1809.5-1816.12
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$4232_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4232__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6419__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6410__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6405__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6154__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6291__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:1811.32-1811.32|top.v:1809.5-1816.12
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$4231_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4231__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6419__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6410__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6405__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6154__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6291__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:1813.35-1813.35|top.v:1809.5-1816.12
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$4229_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4229__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6419__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6410__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6405__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6154__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6291__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:1812.32-1812.32|top.v:1809.5-1816.12
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$4230_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4230__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6419__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6410__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6405__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6154__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6291__o).val(), value<2>{0x2u});
	// \src: top.v:7504.20-7504.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7504$2266
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2279__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10947$3039 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10601$2919
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2062__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1682__o ? value<1>{0x1u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1700__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<112,105>().concat(value<1>{0x1u}).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<124,117>().concat(value<1>{0u}).val())).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<125,117>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10547$2904 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10531$2901 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10519$2898 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3303 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3304_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3305_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$sub$top.v:10376$2848 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3367 $auto$opt_reduce.cc:131:opt_pmux$4703 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10537$2902 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3364 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3361 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3357 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3352 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3346 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3339 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3331 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10239$2831 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10511$2896 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10521$2899 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10506$2895 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10525$2900 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10515$2897
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1679__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<124,117>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<115,8>()).val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1482__o ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<112,105>().concat(value<1>{0x1u}).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<124,117>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<124,117>().concat(value<1>{0u}).val()).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1478__o.slice<10>()).concat((and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1482__o) ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<113>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1478__o.slice<8,0>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1643__o)).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1478__o.slice<9,0>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3323__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<114>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<100,73>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : value<28>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<104,73>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3340__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<68,57>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<72,57>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3347__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<52,49>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<56,49>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3353__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<48,41>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3358__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<36,33>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<40,33>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3362__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<28,25>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<32,25>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3365__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<20,17>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<24,17>().val())).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<124,117>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<115,17>()).val()).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3323__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3340__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3347__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3353__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3358__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3362__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3365__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<16>().val() : value<1>{0x1u}).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1482__o ? value<1>{0u}.concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1624__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1621__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1618__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1612__o).val(), value<3>{0x4u}) ? value<3>{0x7u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1624__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1621__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1618__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1612__o).val(), value<4>{0x8u}) ? value<3>{0x3u} : value<3>{0x1u}))).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o).val() : sub_uu<4>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left, value<1>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field).val())).val() : value<1>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field).val())).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$and$top.v:1014$316 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$not$top.v:1012$315 $flatten\unity_link_inst.\core_inst.$or$top.v:13000$3264 $flatten\unity_link_inst.\core_inst.$or$top.v:12998$3263 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$or$top.v:1467$393 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1465$392 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ne$top.v:1463$391 $flatten\unity_link_inst.\core_inst.$or$top.v:12996$3262 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2445$742 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2443$741 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:2441$740 $flatten\unity_link_inst.\core_inst.$or$top.v:12994$3261 $flatten\unity_link_inst.\core_inst.$or$top.v:12992$3260 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10003$2781 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10001$2780 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:9999$2779 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:9997$2778 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:9993$2777 $flatten\unity_link_inst.\core_inst.$or$top.v:12990$3259 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$or$top.v:11377$3057 $flatten\unity_link_inst.\core_inst.$or$top.v:12988$3258
	p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6564__o = and_uu<1>(not_u<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr, p_unity__link__inst_2e_core__inst_2e_character__valid.curr), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<40>().val(), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<54>().val())), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<126>().val(), (or_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<4,0>().val(), value<5>{0x10u}), reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<11,8>().val())) ? value<1>{0x1u} : value<1>{0u}))), p_unity__link__inst_2e_core__inst_2e_hold), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<88>().val(), (reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<2,0>().val()) ? value<1>{0x1u} : value<1>{0u}))), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<25>().val(), (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<2,0>().val(), value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u}))), p_out__valid.curr)), p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6594__q.curr);
	// \src: top.v:5253.20-5253.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5253$1776
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4298__o = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4291__o ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5245$1772 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5243$1771
	p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write = or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4232__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4245__o), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4182__o);
	// \src: top.v:5271.20-5271.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5271$1785
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4318__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4877__q.curr, value<3>{0x7u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7500$2265 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7498$2264
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__done, (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3559__o ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8662$2611 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8647$2605 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8268$2499 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3716 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8620$2596 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8611$2593 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3604 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3606_CMP0 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8624$2597 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8627$2598 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8631$2599 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8009$2424 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3776
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3124__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<14>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<133>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<13,12>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2716__o).concat(value<3>{0x7u}).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2696__o.concat(value<1>{0u}).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3623__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<24,17>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2716__o)).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2690__o).val()) : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<13,12>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3078__o.slice<10,9>().val()).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<15>().val() ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3078__o.slice<8>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<10,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3078__o.slice<7,0>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<15>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<11>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val() : value<3>{0x7u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3588__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3048__o.slice<2,0>().val() : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1698__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3068__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3059__o).val(), value<3>{0x4u}) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val() : value<3>{0x7u})))).val()) : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<133>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<13,3>().concat(value<3>{0x7u}).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2696__o.concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3623__CMP ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<24,17>()).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<11,3>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2690__o).val()));
	// \src: top.v:7764.20-7764.44
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:7764$2353
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2539__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<132,129>().val());
	// \src: top.v:8847.20-8847.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8847$2670
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3276__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val(), value<3>{0x5u});
	// \src: top.v:8816.20-8816.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8816$2661
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3246__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val(), value<2>{0x3u});
	// \src: top.v:8724.20-8724.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8724$2632
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3171__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val(), value<2>{0x2u});
	// \src: top.v:8722.20-8722.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8722$2631
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3167__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6261$2126 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6255$2123 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6253$2122 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6251$2121 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6249$2120
	p_unity__link__inst_2e_core__inst_2e_access__granted = and_uu<1>(and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<56>().val(), not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3455__o)), not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3643__q.curr)), p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3465__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7542$2281 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7540$2280 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7494$2262 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7492$2261 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7490$2260
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2312__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__done, (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_access__failure.curr) ? value<1>{0x1u} : value<1>{0u})), not_u<1>(p_unity__link__inst_2e_core__inst_2e_access__write));
	// \src: top.v:6317.20-6317.48
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:6317$2154
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3538__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q.curr);
	// \src: top.v:6337.20-6337.34
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:6337$2164
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3557__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3641__q.curr, value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7522$2272 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7520$2271 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7518$2270
	p_unity__link__inst_2e_core__inst_2e_access__more = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue));
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1182$353 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$not$top.v:1180$352
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6504__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_n198__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6455__o));
	// \src: top.v:2730.20-2730.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:2730$835
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5464__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5462__o);
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2778$852 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2772$849 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2766$846
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5513__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5471__o ? value<6>{0x3u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5476__o ? value<6>{0x3fu} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<9>().val() ? value<2>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<22,19>()).val() : value<3>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5504__o_5b_2_3a_0_5d_).val())));
	// \src: top.v:2973.20-2973.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$sub$top.v:2973$911
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5753__o = sub_uu<6>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<77,72>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2776$851 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2770$848 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2764$845
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5512__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5471__o ? value<3>{0x5u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5476__o ? value<3>{0x6u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<9>().val() ? value<3>{0x3u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5503__o)));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:3178$962 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:3171$959
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5974__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<39,31>().val(), value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5099__o);
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2780$853 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2774$850 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2768$847 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2756$841
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5514__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5471__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5476__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<9>().val() ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5505__o ? value<1>{0x1u} : value<1>{0u}))));
	// \full_case: 1
	// \src: top.v:3464.37-3464.37|top.v:3458.5-3467.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4044_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4044__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5710__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5096__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5138__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5115__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5682__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5520__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5038__o).val(), value<1>{0x1u});
	// cell $auto$opt_reduce.cc:131:opt_pmux$4665
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4638 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4045__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4046__CMP).val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$4723
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4716 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4047__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4048__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4049__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4050__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7574$2292 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7572$2291
	p_unity__link__inst_2e_core__inst_2e_group__request = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2342__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o) ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:5466.20-5466.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5466$1865
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4546__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4877__q.curr, value<2>{0x2u});
	// \src: top.v:5456.20-5456.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5456$1860
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4535__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4877__q.curr, value<1>{0x1u});
	// \src: top.v:5283.20-5283.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5283$1791
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4340__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<60,58>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5281$1790 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5279$1789 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$or$top.v:318$54 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$or$top.v:316$53 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$or$top.v:314$52 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5277$1788
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out = and_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4328__o ? value<1>{0x1u} : value<1>{0u}), not_u<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6923__q.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6925__q.curr), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick.curr)));
	// \full_case: 1
	// \src: top.v:6053.32-6053.32|top.v:6052.5-6057.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3872_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3872__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<42,41>().val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:6052.19-6052.19|top.v:6052.5-6057.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3873_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3873__CMP = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<42,41>().val());
	// \full_case: 1
	// \src: top.v:6054.32-6054.32|top.v:6052.5-6057.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3871_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3871__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<42,41>().val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6055.32-6055.32|top.v:6052.5-6057.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3870_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3870__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<42,41>().val(), value<2>{0x3u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:337$61 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:335$60 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:333$59
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counts, (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter.curr, value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1587$417 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1582$416 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$eq$top.v:1578$415 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$add$top.v:1574$414 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1570$413 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4585
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6286__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<88>().val() ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6239__o_5b_2_3a_0_5d_.slice<2>().concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6246__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6253__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6260__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6267__o_5b_2_3a_0_5d_.slice<2>()).concat((p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6232__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6267__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6267__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val())).concat(add_uu<2>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<4,3>().val(), value<1>{0x1u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<4,3>().val(), value<2>{0x2u}) ? value<3>{0x1u} : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<2,0>().val())).val() : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<12,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$and$top.v:1010$314 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$eq$top.v:1008$313
	p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6562__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark.curr, value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left.curr);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3828$1531 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2425$739 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2423$738 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$add$top.v:3826$1530
	p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n4985__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5068__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<78>().val())) ? add_uu<11>(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5016__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5016__q.curr);
	// \src: top.v:5273.20-5273.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5273$1786
	p_unity__link__inst_2e_core__inst_2e_group__done = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4318__o ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:8825.20-8825.44
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8825$2664
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3256__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<54,47>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<141,134>().val());
	// \full_case: 1
	// \src: top.v:9047.19-9047.19|top.v:9047.5-9057.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3465_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3465__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2316__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3276__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2342__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3246__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3171__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3167__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2279__o).val(), value<8>{0x80u});
	// \full_case: 1
	// \src: top.v:9048.38-9048.38|top.v:9047.5-9057.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3464_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3464__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2316__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3276__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2342__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3246__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3171__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3167__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2279__o).val(), value<7>{0x40u});
	// \full_case: 1
	// \src: top.v:9049.38-9049.38|top.v:9047.5-9057.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3463_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3463__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2316__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3276__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2342__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3246__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3171__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3167__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2279__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:9050.38-9050.38|top.v:9047.5-9057.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3462_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3462__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2316__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3276__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2342__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3246__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3171__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3167__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2279__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:9051.38-9051.38|top.v:9047.5-9057.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3461_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3461__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2316__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3276__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2342__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3246__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3171__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3167__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2279__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:9052.38-9052.38|top.v:9047.5-9057.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3460_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3460__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2316__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3276__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2342__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3246__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3171__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3167__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2279__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:9053.38-9053.38|top.v:9047.5-9057.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3459_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3459__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2316__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3276__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2342__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3246__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3171__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3167__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2279__o).val(), value<2>{0x2u});
	// \src: top.v:8732.20-8732.41
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$add$top.v:8732$2634
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3176__o = add_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<54,47>().val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:9054.38-9054.38|top.v:9047.5-9057.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3458_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3458__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2316__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3276__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2342__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3246__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3171__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3167__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2279__o).val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\wishbone_master_inst.$and$top.v:12254$3256 $flatten\unity_link_inst.\wishbone_master_inst.$or$top.v:12252$3255
	p_unity__link__inst_2e_bus__done = and_uu<1>(p_wb__stb.curr, or_uu<1>(p_wb__ack, p_wb__err));
	// \src: top.v:6295.20-6295.40
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$or$top.v:6295$2143
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3520__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample, p_unity__link__inst_2e_core__inst_2e_access__granted);
	// \full_case: 1
	// \src: top.v:6453.19-6453.19|top.v:6453.5-6458.12
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3803_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3803__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3486__o.concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3557__o).concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3458__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:6454.35-6454.35|top.v:6453.5-6458.12
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3802_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3802__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3486__o.concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3557__o).concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3458__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6455.33-6455.33|top.v:6453.5-6458.12
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3801_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3801__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3486__o.concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3557__o).concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3458__o).val(), value<1>{0x1u});
	// cell $auto$opt_reduce.cc:131:opt_pmux$4709
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4630 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4045__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4046__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4047__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4048__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4049__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4050__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2570$777 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2545$771
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5233__o = (p_unity__link__inst_2e_core__inst_2e_answer__taken ? value<2>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5068__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6134__q.curr.slice<6>().concat(value<1>{0x1u}).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<79,78>().val()));
	// cell $auto$opt_reduce.cc:131:opt_pmux$4705
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4692 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4045__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4046__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4047__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4048__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4050__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2556$773 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7718$2338 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7710$2336 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2539$769
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5223__o = (p_unity__link__inst_2e_core__inst_2e_answer__taken ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<20>().concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2369__o ? value<5>{0x10u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<74>().val() ? value<5>{0x11u} : value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<19,16>()).val()))).concat(value<3>{0x1u}).val() : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5068__o ? value<9>{0x91u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<8,0>().val()));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2560$774 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2515$766 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7640$2309 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7636$2307 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7634$2306 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7630$2305 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7720$2339 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7688$2329 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3788 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7680$2327 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7678$2326 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7676$2325 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7674$2324 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7672$2323 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7670$2322 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7668$2321 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7666$2320 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7664$2319 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7662$2318 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7660$2317 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7656$2315 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7652$2313 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7648$2311 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2520$767 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7712$2337 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7722$2340 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7626$2304
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5226__o = (p_unity__link__inst_2e_core__inst_2e_answer__taken ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2369__o ? value<4>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<73,70>()).val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<19>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<48,41>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<141,134>().val())).concat(value<4>{0x1u}).concat((p_unity__link__inst_2e_core__inst_2e_answer__has__id ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<74>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<10,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<30,23>().val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<32,25>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2369__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<20>().val() ? value<1>{0u} : (or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<19,16>().val(), value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2226__o), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2211__o), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2214__o), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<19,16>().val(), value<4>{0x8u})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<19,16>().val(), value<4>{0x9u})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<19,16>().val(), value<4>{0xau})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<19,16>().val(), value<4>{0xbu})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<19,16>().val(), value<4>{0xcu})) ? value<1>{0x1u} : value<1>{0u})))).concat(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_answer__has__id, and_uu<1>(and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<20>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<19>().val())), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2395__o))).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<30,9>().val());
	// \full_case: 1
	// \src: top.v:5822.37-5822.37|top.v:5819.5-5829.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3931_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3931__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4318__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4328__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4291__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4174__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4223__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4546__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4535__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3828__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:5821.37-5821.37|top.v:5819.5-5829.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3932_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3932__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4318__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4328__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4291__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4174__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4223__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4546__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4535__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3828__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:5820.37-5820.37|top.v:5819.5-5829.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3933_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3933__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4318__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4328__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4291__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4174__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4223__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4546__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4535__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3828__o).val(), value<7>{0x40u});
	// \full_case: 1
	// \src: top.v:5819.19-5819.19|top.v:5819.5-5829.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3934_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3934__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4318__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4328__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4291__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4174__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4223__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4546__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4535__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3828__o).val(), value<8>{0x80u});
	// \full_case: 1
	// \src: top.v:5825.37-5825.37|top.v:5819.5-5829.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3928_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3928__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4318__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4328__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4291__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4174__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4223__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4546__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4535__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3828__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:5824.38-5824.38|top.v:5819.5-5829.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3929_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3929__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4318__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4328__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4291__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4174__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4223__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4546__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4535__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3828__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:5823.38-5823.38|top.v:5819.5-5829.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3930_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3930__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4318__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4328__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4291__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4174__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4223__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4546__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4535__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3828__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:5826.37-5826.37|top.v:5819.5-5829.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3927_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3927__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4318__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4328__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4291__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4174__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4223__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4546__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4535__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3828__o).val(), value<1>{0x1u});
	// \src: top.v:5118.20-5118.25
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5118$1732
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4089__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<9>().val());
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12091$3211 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$not$top.v:12089$3210
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n286__o = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o), p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o);
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12081$3206 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$or$top.v:12079$3205 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12077$3204 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$eq$top.v:12073$3202
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n279__o = and_uu<1>(or_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o, p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n276__o)), p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o);
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1172$348 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$not$top.v:1170$347
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6496__o = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_n198__o), p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6455__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10978$3047 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7506$2267
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2084__o = and_uu<1>((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2279__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<126>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10974$3046 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9925$2765 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9919$2762 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10956$3041 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10542$2903 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10161$2816 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3382 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3429 $auto$opt_reduce.cc:131:opt_pmux$4697 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3416 $auto$opt_reduce.cc:131:opt_pmux$4713 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3406 $auto$opt_reduce.cc:131:opt_pmux$4711 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3394 $auto$opt_reduce.cc:131:opt_pmux$4707 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3376 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3420 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3412 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3400 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3388 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10169$2817 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10177$2819 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10175$2818 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10959$3042 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10597$2918 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10943$3038 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10592$2917 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10962$3043 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10966$3044 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10970$3045 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10950$3040 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10939$3037 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:10784$2983 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10937$3036 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10816$2993 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10798$2987 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10788$2984 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10796$2986 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10794$2985 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10814$2992 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10812$2991 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10810$2990 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10804$2988 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10935$3035 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10931$3033 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3285 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3286_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3287_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3288_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10898$3024 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10894$3022 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10890$3020 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10886$3018 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10878$3014 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10892$3021 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10888$3019 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10858$3007 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10880$3015 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10876$3013 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10914$3028 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10904$3026 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10912$3027 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10748$2971 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3294 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3295_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3296_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3297_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3298_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3299_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10623$2926 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:10621$2925 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10646$2934 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10639$2933 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:10635$2931 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:10637$2932 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10703$2955 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10696$2954 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:10694$2953 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10690$2952 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10684$2950 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10682$2949 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10678$2948 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:10676$2947 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:10727$2965 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3290 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3291_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3292_CMP0
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2082__o = (and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<54>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1154__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1157__o) ? (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<55>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1682__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<141,126>().val() : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1904__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1898__o).val(), value<1>{0x1u}) ? value<8>{0x1u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1904__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1898__o).val(), value<2>{0x2u}) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<112,105>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<40,33>().val())).concat(((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1854__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1801__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<1>{0x1u}) ? or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1757__o, gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<40,33>().val(), value<8>{0xffu})) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1854__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1801__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<2>{0x2u}) ? or_uu<1>(and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<3,0>().val(), value<2>{0x3u}), gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<113,105>().val(), value<8>{0xffu})), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<115>().val()) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1854__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1801__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<3>{0x4u}) ? or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1804__o, reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<56,55>().concat(value<6>{0u}).val())), logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<72,57>().val())), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1757__o), gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<40,33>().val(), value<6>{0x20u})), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<115>().val()) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1854__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1801__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<4>{0x8u}) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1804__o : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1854__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1801__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<5>{0x10u}) ? gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<48,41>().val(), value<2>{0x2u}) : value<1>{0u}))))) ? value<1>{0x1u} : value<1>{0u})).concat((reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<60,57>().val()) ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<60,57>().val() : (and_uu<1>(not_u<1>(and_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<3,0>().val(), value<4>{0xeu}), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<5>().val())), and_uu<1>(not_u<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<6>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<7>().val())), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<4>().val()))) ? value<2>{0u}.concat(((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<16>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1951__o : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1959__o).val(), value<1>{0x1u}) ? value<1>{0x1u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1959__o).val(), value<2>{0x2u}) ? ((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<16>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1945__o : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1970__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1800__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2003__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1945__o)))) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1970__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1800__o ? eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<113,105>().val(), value<2>{0x2u}) : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2003__o ? eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<113,105>().val(), value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1951__o)))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1959__o).val(), value<3>{0x4u}) ? and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<113,105>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<40,33>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<114>().val())) : value<1>{0u})))) ? value<2>{0u} : value<2>{0x3u})).val() : value<4>{0x2u}))).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<61>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<56>()).concat(value<1>{0x1u}).val()).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2062__o.slice<9>()).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<141,125>().val()).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<55>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2062__o.slice<8,0>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1679__o.slice<116,108>().val())).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<55>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<115>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1679__o.slice<107>().val())).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<55>().val() ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1700__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1682__o) ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<113>().val() ? value<1>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<112,105>()).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1643__o)).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<114,105>().val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1679__o.slice<106,97>().val())).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<55>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<104,0>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1679__o.slice<96,0>().concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter ? or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<7>().val(), not_u<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<51>().val())).concat(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<6>().val(), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<51>().val())).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<51>()).concat(((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3377__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3421__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3422__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3423__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3424__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3425__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3426__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3427__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3378__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3413__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3414__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3379__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3401__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3402__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3403__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3404__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3380__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3389__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3390__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3391__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3392__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : value<1>{0x1u})))) ? value<5>{0x1fu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3377__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3421__CMP ? value<5>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3422__CMP ? value<5>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3423__CMP ? value<5>{0xdu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3424__CMP ? value<5>{0xeu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3425__CMP ? value<5>{0xfu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3426__CMP ? value<5>{0xcu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3427__CMP ? value<5>{0x11u} : value<5>{0u}))))))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3378__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3413__CMP ? value<5>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3414__CMP ? value<5>{0x2u} : value<5>{0u})) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3379__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3401__CMP ? value<5>{0x5u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3402__CMP ? value<5>{0x7u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3403__CMP ? value<5>{0x6u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3404__CMP ? value<5>{0x3u} : value<5>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3380__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3389__CMP ? value<5>{0x8u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3390__CMP ? value<5>{0x9u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3391__CMP ? value<5>{0xau} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3392__CMP ? value<5>{0xbu} : value<5>{0u})))) : value<5>{0u})))))).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<7,0>().val())).val())).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<141,117>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<115,0>()).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$and$top.v:1006$312 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$eq$top.v:1004$311
	p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6559__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark.curr, value<2>{0x2u}), p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left.curr);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3822$1528 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5263$1781 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5261$1780 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3820$1527 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$add$top.v:3818$1526
	p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n4981__o = (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4298__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted)) ? p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.curr : (p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write ? add_uu<11>(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5014__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5014__q.curr));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8702$2624 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8678$2617 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8682$2618
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3151__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<126>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2539__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<13,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3124__o.slice<13,3>().val()).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2539__o ? value<3>{0x7u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3124__o.slice<2,0>().val())).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<13,0>().val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$4687
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4668 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3459__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3460__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3461__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3462__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3463__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3464__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3465__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8705$2625 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8684$2619 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8664$2612
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3153__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<126>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<141,134>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<32,17>()).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<128,127>()).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2539__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<5>().val() ? value<1>{0x1u} : value<1>{0u}))).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<3,0>()).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<46,16>().val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$4681
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4670 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3459__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3460__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3462__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3463__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3464__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3465__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8812$2659 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8793$2653 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8778$2648 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8768$2645 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8797$2654 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8781$2649
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3242__o = (p_unity__link__inst_2e_core__inst_2e_access__done ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<57>().val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2251__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<57>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2251__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<56>().val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<56>().val())))).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<57,56>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8707$2626 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8687$2620 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8666$2613 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8651$2607 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8636$2601 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3594 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8690$2621 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8668$2614 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8653$2608 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8639$2602 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3591
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3154__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<126>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2539__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<60,58>().val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<14>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2711__o : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<60,58>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3588__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2711__o : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<60,58>().val()))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2711__o)).concat(value<1>{0u}).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2539__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<56>().val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<14>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2709__o : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<56>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3588__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2709__o : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<56>().val()))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2709__o))).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<60,56>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8710$2627 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8693$2622 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8671$2615 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8656$2609 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8641$2603 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3587 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3589_CMP0 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8696$2623 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8674$2616 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8659$2610 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8643$2604 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8616$2595
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3156__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<126>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2539__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<14>().val() ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<15>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<11>().val() ? value<1>{0u} : value<1>{0x1u}) : value<1>{0u})) : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2539__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<132,129>().val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<14>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2712__o : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<15>().val() ? value<4>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3588__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2712__o : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1698__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3068__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3059__o).val(), value<2>{0x2u}) ? value<4>{0x8u} : value<4>{0u})))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2712__o))).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<74,70>().val());
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6581$2215 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7562$2288 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7560$2287 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6579$2214 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$add$top.v:6577$2213
	p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3401__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2323__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<22>().val())) ? p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.curr : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2312__o ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3434__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3434__q.curr));
	// cell $auto$opt_reduce.cc:131:opt_pmux$4657
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4652 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3802__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3803__CMP).val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$4661
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4660 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3801__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3803__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1162$343 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$or$top.v:1160$342 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1158$341 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$eq$top.v:1154$339
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6489__o = and_uu<1>(or_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_n198__o, p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6486__o)), p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6455__o);
	// \src: top.v:949.20-949.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$eq$top.v:949$304
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6602__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6616__q.curr);
	// cell $auto$opt_reduce.cc:131:opt_pmux$4643
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4642 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3928__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3929__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3930__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3931__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3932__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3933__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3934__CMP).val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$4631
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4626 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3928__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3929__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3930__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3932__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3933__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3934__CMP).val());
	// \src: top.v:5299.20-5299.39
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5299$1799
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4370__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4298__o);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5287$1793 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5285$1792
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4348__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4340__o ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$or$top.v:353$64 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5293$1796 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5291$1795 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5289$1794
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6670__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counts, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out, (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<60,58>().val(), value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u})));
	// memory \unity_link_inst.core_inst.rx_fifo_inst.memory read port 0
	auto tmp_4 = memory_index(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n334__q.curr, 0, 256);
	CXXRTL_ASSERT(tmp_4.valid && "out of bounds read");
	if(tmp_4.valid) {
		value<9> tmp_5 = memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory[tmp_4.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_12159_24_3241__DATA = tmp_5;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_12159_24_3241__DATA = value<9> {};
	}
	// \src: top.v:1144.20-1144.51
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1144$334
	p_unity__link__inst_2e_core__inst_2e_tx__entry = (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6551__q.curr ? p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.curr : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6552__data.curr);
	// memory \unity_link_inst.core_inst.tx_fifo_inst.memory read port 0
	auto tmp_6 = memory_index(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6544__q.curr, 0, 256);
	CXXRTL_ASSERT(tmp_6.valid && "out of bounds read");
	if(tmp_6.valid) {
		value<10> tmp_7 = memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory[tmp_6.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_1240_24_378__DATA = tmp_7;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_1240_24_378__DATA = value<10> {};
	}
	// \full_case: 1
	// \src: top.v:9084.9-9084.14|top.v:9084.5-9085.41
	// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procmux$3448
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_9085_24_2692__EN_5b_31_3a_0_5d__24_2698_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<116>().val() ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:12161.9-12161.13|top.v:12161.5-12162.35
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$3266
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_12162_24_3194__EN_5b_8_3a_0_5d__24_3245_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:5982.9-5982.18|top.v:5982.5-5983.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3890
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_last_24_top_2e_v_3a_5983_24_1590__EN_5b_31_3a_0_5d__24_2038_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4182__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:5972.9-5972.19|top.v:5972.5-5973.37
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3899
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_list_24_top_2e_v_3a_5973_24_1589__EN_5b_7_3a_0_5d__24_2029_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<61>().val() ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:5962.9-5962.20|top.v:5962.5-5963.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3908
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_state__memory_24_top_2e_v_3a_5963_24_1588__EN_5b_9_3a_0_5d__24_2020_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4370__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:5934.9-5934.23|top.v:5934.5-5935.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3917
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5935_24_1571__EN_5b_13_3a_0_5d__24_2011_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4348__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:5934.9-5934.23|top.v:5934.5-5935.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3923
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5935_24_1571__ADDR_5b_3_3a_0_5d__24_2009 = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4348__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr : value<4>{0u});
	// \full_case: 1
	// \src: top.v:1242.9-1242.13|top.v:1242.5-1243.35
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$4280
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_1243_24_331__EN_5b_9_3a_0_5d__24_382_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6455__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:3868.9-3868.14|top.v:3868.5-3869.37
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procmux$4034
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_3869_24_1525__EN_5b_31_3a_0_5d__24_1551_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:6627.9-6627.14|top.v:6627.5-6628.37
	// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procmux$3791
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_6628_24_2212__EN_5b_31_3a_0_5d__24_2238_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2312__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:661.9-661.22|top.v:661.5-662.44
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4375
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_counters_24_top_2e_v_3a_662_24_34__EN_5b_15_3a_0_5d__24_174_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6670__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:692.9-692.15|top.v:692.5-693.40
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4366
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_losses_24_top_2e_v_3a_693_24_51__EN_5b_7_3a_0_5d__24_185_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due ? value<1>{0x1u} : value<1>{0u});
	// memory \unity_link_inst.core_inst.request_memory_inst.memory read port 0
	auto tmp_8 = memory_index(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<54,47>().val(), 0, 256);
	CXXRTL_ASSERT(tmp_8.valid && "out of bounds read");
	if(tmp_8.valid) {
		value<32> tmp_9 = memory_p_unity__link__inst_2e_core__inst_2e_request__memory__inst_2e_memory[tmp_8.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2163__data_5b_31_3a_0_5d_ = tmp_9;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2163__data_5b_31_3a_0_5d_ = value<32> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_sample_ring_inst.memory read port 0
	auto tmp_10 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5016__q.curr.slice<9,0>().val(), 0, 1024);
	CXXRTL_ASSERT(tmp_10.valid && "out of bounds read");
	if(tmp_10.valid) {
		value<32> tmp_11 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_memory[tmp_10.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_5c_n5021__data_5b_31_3a_0_5d_ = tmp_11;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_5c_n5021__data_5b_31_3a_0_5d_ = value<32> {};
	}
	// memory \unity_link_inst.core_inst.response_ring_inst.memory read port 0
	auto tmp_12 = memory_index(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3436__q.curr.slice<7,0>().val(), 0, 256);
	CXXRTL_ASSERT(tmp_12.valid && "out of bounds read");
	if(tmp_12.valid) {
		value<32> tmp_13 = memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory[tmp_12.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3441__data_5b_31_3a_0_5d_ = tmp_13;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3441__data_5b_31_3a_0_5d_ = value<32> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.losses read port 1
	auto tmp_14 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6924__q.curr, 0, 16);
	CXXRTL_ASSERT(tmp_14.valid && "out of bounds read");
	if(tmp_14.valid) {
		value<8> tmp_15 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses[tmp_14.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6949__data_5b_7_3a_0_5d_ = tmp_15;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6949__data_5b_7_3a_0_5d_ = value<8> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.losses read port 0
	auto tmp_16 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.curr, 0, 16);
	CXXRTL_ASSERT(tmp_16.valid && "out of bounds read");
	if(tmp_16.valid) {
		value<8> tmp_17 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses[tmp_16.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6947__data_5b_7_3a_0_5d_ = tmp_17;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6947__data_5b_7_3a_0_5d_ = value<8> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.counters read port 0
	auto tmp_18 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6924__q.curr, 0, 16);
	CXXRTL_ASSERT(tmp_18.valid && "out of bounds read");
	if(tmp_18.valid) {
		value<16> tmp_19 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters[tmp_18.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6943__data_5b_15_3a_0_5d_ = tmp_19;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6943__data_5b_15_3a_0_5d_ = value<16> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.divisors read port 0
	auto tmp_20 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6924__q.curr, 0, 16);
	CXXRTL_ASSERT(tmp_20.valid && "out of bounds read");
	if(tmp_20.valid) {
		value<16> tmp_21 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors[tmp_20.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6939__data_5b_15_3a_0_5d_ = tmp_21;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6939__data_5b_15_3a_0_5d_ = value<16> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.settings_memory read port 0
	auto tmp_22 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr, 0, 16);
	CXXRTL_ASSERT(tmp_22.valid && "out of bounds read");
	if(tmp_22.valid) {
		value<14> tmp_23 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory[tmp_22.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4903__data_5b_13_3a_0_5d_ = tmp_23;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4903__data_5b_13_3a_0_5d_ = value<14> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.state_memory read port 0
	auto tmp_24 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr, 0, 16);
	CXXRTL_ASSERT(tmp_24.valid && "out of bounds read");
	if(tmp_24.valid) {
		value<10> tmp_25 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory[tmp_24.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4907__data_5b_9_3a_0_5d_ = tmp_25;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4907__data_5b_9_3a_0_5d_ = value<10> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.list read port 0
	auto tmp_26 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr.slice<4,0>()).val(), 0, 512);
	CXXRTL_ASSERT(tmp_26.valid && "out of bounds read");
	if(tmp_26.valid) {
		value<8> tmp_27 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_list[tmp_26.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4910__data_5b_7_3a_0_5d_ = tmp_27;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4910__data_5b_7_3a_0_5d_ = value<8> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.last read port 0
	auto tmp_28 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4893__q.curr.slice<4,0>()).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<9>()).val(), 0, 1024);
	CXXRTL_ASSERT(tmp_28.valid && "out of bounds read");
	if(tmp_28.valid) {
		value<32> tmp_29 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last[tmp_28.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4913__data_5b_31_3a_0_5d_ = tmp_29;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4913__data_5b_31_3a_0_5d_ = value<32> {};
	}
	// memory \unity_link_inst.core_inst.request_memory_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:9084.9-9084.14|top.v:9084.5-9085.41
		// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procmux$3454
		auto tmp_30 = memory_index((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<116>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<124,117>().val() : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_30.valid && "out of bounds write");
		if (tmp_30.valid) {
			// \full_case: 1
			// \src: top.v:9084.9-9084.14|top.v:9084.5-9085.41
			// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procmux$3451
			memory_p_unity__link__inst_2e_core__inst_2e_request__memory__inst_2e_memory.update(tmp_30.index, (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<116>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<104,73>().val() : value<32>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_9085_24_2692__EN_5b_31_3a_0_5d__24_2698_5b_0_5d_.repeat<32>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.rx_fifo_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:12161.9-12161.13|top.v:12161.5-12162.35
		// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$3272
		auto tmp_31 = memory_index((p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o ? p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n333__q.curr : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_31.valid && "out of bounds write");
		if (tmp_31.valid) {
			// \full_case: 1
			// \src: top.v:12161.9-12161.13|top.v:12161.5-12162.35
			// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$3269
			memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory.update(tmp_31.index, (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o ? p_in__lost.concat(p_in__data).val() : value<9>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_12162_24_3194__EN_5b_8_3a_0_5d__24_3245_5b_0_5d_.repeat<9>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.last write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:5982.9-5982.18|top.v:5982.5-5983.41
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3896
		auto tmp_32 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4182__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4893__q.curr.slice<4,0>()).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4089__o).val() : value<10>{0u}), 0, 1024);
		CXXRTL_ASSERT(tmp_32.valid && "out of bounds write");
		if (tmp_32.valid) {
			// \full_case: 1
			// \src: top.v:5982.9-5982.18|top.v:5982.5-5983.41
			// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3893
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last.update(tmp_32.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4182__o ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.curr : value<32>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_last_24_top_2e_v_3a_5983_24_1590__EN_5b_31_3a_0_5d__24_2038_5b_0_5d_.repeat<32>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.list write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:5972.9-5972.19|top.v:5972.5-5973.37
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3905
		auto tmp_33 = memory_index((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<61>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<66,62>()).val() : value<9>{0u}), 0, 512);
		CXXRTL_ASSERT(tmp_33.valid && "out of bounds write");
		if (tmp_33.valid) {
			// \full_case: 1
			// \src: top.v:5972.9-5972.19|top.v:5972.5-5973.37
			// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3902
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_list.update(tmp_33.index, (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<61>().val() ? p_unity__link__inst_2e_core__inst_2e_memory__word.curr.slice<7,0>().val() : value<8>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_list_24_top_2e_v_3a_5973_24_1589__EN_5b_7_3a_0_5d__24_2029_5b_0_5d_.repeat<8>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.state_memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:5962.9-5962.20|top.v:5962.5-5963.41
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3914
		auto tmp_34 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4370__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr : value<4>{0u}), 0, 16);
		CXXRTL_ASSERT(tmp_34.valid && "out of bounds write");
		if (tmp_34.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3911 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5319$1809 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5313$1806 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5309$1804 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5311$1805 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5317$1808 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5321$1810 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5305$1802 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5307$1803 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5323$1811
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory.update(tmp_34.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4370__o ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4291__o) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4089__o : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<9>().val()).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4291__o ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<8>().val()) : value<1>{0x1u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4291__o ? (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr) ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4315__o, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4315__o) : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4340__o ? value<8>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<7,0>().val()))).val() : value<10>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_state__memory_24_top_2e_v_3a_5963_24_1588__EN_5b_9_3a_0_5d__24_2020_5b_0_5d_.repeat<10>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.settings_memory write port 0
	if (posedge_p_clk) {
		auto tmp_35 = memory_index(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5935_24_1571__ADDR_5b_3_3a_0_5d__24_2009, 0, 16);
		CXXRTL_ASSERT(tmp_35.valid && "out of bounds write");
		if (tmp_35.valid) {
			// \full_case: 1
			// \src: top.v:5934.9-5934.23|top.v:5934.5-5935.42
			// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3920
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory.update(tmp_35.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4348__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<141,134>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<54,49>()).val() : value<14>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5935_24_1571__EN_5b_13_3a_0_5d__24_2011_5b_0_5d_.repeat<14>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.tx_fifo_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:1242.9-1242.13|top.v:1242.5-1243.35
		// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$4286
		auto tmp_36 = memory_index((p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6455__o ? p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6543__q.curr : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_36.valid && "out of bounds write");
		if (tmp_36.valid) {
			// \full_case: 1
			// \src: top.v:1242.9-1242.13|top.v:1242.5-1243.35
			// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$4283
			memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory.update(tmp_36.index, (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6455__o ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<24,15>().val() : value<10>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_1243_24_331__EN_5b_9_3a_0_5d__24_382_5b_0_5d_.repeat<10>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_sample_ring_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:3868.9-3868.14|top.v:3868.5-3869.37
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procmux$4040
		auto tmp_37 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write ? p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5014__q.curr.slice<9,0>().val() : value<10>{0u}), 0, 1024);
		CXXRTL_ASSERT(tmp_37.valid && "out of bounds write");
		if (tmp_37.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procmux$4037 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5247$1773 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5249$1774
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_memory.update(tmp_37.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4232__o ? value<4>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4315__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4250__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4881__q.curr.slice<3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4881__q.curr.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4881__q.curr.slice<2>()).concat(value<4>{0u}).val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4245__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4891__q.curr : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.curr)) : value<32>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_3869_24_1525__EN_5b_31_3a_0_5d__24_1551_5b_0_5d_.repeat<32>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.response_ring_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:6627.9-6627.14|top.v:6627.5-6628.37
		// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procmux$3797
		auto tmp_38 = memory_index((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2312__o ? p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3434__q.curr.slice<7,0>().val() : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_38.valid && "out of bounds write");
		if (tmp_38.valid) {
			// \full_case: 1
			// \src: top.v:6627.9-6627.14|top.v:6627.5-6628.37
			// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procmux$3794
			memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory.update(tmp_38.index, (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2312__o ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.curr : value<32>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_6628_24_2212__EN_5b_31_3a_0_5d__24_2238_5b_0_5d_.repeat<32>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.divisors write port 0
	if (posedge_p_clk) {
		auto tmp_39 = memory_index(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5935_24_1571__ADDR_5b_3_3a_0_5d__24_2009, 0, 16);
		CXXRTL_ASSERT(tmp_39.valid && "out of bounds write");
		if (tmp_39.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4387 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5100$1731
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors.update(tmp_39.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4348__o ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<49>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<72,57>().val() : value<16>{0u}) : value<16>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5935_24_1571__EN_5b_13_3a_0_5d__24_2011_5b_0_5d_.repeat<16>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.counters write port 0
	if (posedge_p_clk) {
		// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4381 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:355$65
		auto tmp_40 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6670__o ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr) : value<4>{0u}), 0, 16);
		CXXRTL_ASSERT(tmp_40.valid && "out of bounds write");
		if (tmp_40.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4378 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:361$67 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:363$68 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$sub$top.v:365$69
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters.update(tmp_40.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6670__o ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor.curr : sub_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter.curr, value<1>{0x1u})) : value<16>{0x1u}) : value<16>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_counters_24_top_2e_v_3a_662_24_34__EN_5b_15_3a_0_5d__24_174_5b_0_5d_.repeat<16>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.losses write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:692.9-692.15|top.v:692.5-693.40
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4372
		auto tmp_41 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr : value<4>{0u}), 0, 16);
		CXXRTL_ASSERT(tmp_41.valid && "out of bounds write");
		if (tmp_41.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4369 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:369$71 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:351$63 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$not$top.v:349$62 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4290 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4295 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4300 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4305 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4310 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4315 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4320 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4325 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4330 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4335 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$add$top.v:367$70
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses.update(tmp_41.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due ? (and_uu<1>((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4291__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4296__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4297__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<14>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4298__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<13>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4299__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<12>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4292__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4296__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<11>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4297__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<10>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4298__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4299__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<8>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4293__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4296__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<7>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4297__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<6>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4298__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4299__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<4>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4294__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4296__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4297__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<2>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4298__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<1>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4299__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<0>().val() : value<1>{0u})))) : value<1>{0u})))), not_u<1>((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4291__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4296__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4297__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<14>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4298__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<13>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4299__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<12>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4292__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4296__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<11>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4297__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<10>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4298__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4299__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<8>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4293__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4296__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<7>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4297__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<6>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4298__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4299__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<4>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4294__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4296__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4297__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<2>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4298__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<1>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4299__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<0>().val() : value<1>{0u})))) : value<1>{0u})))))) ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__losses.curr, value<1>{0x1u}) : value<8>{0u}) : value<8>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_losses_24_top_2e_v_3a_693_24_51__EN_5b_7_3a_0_5d__24_185_5b_0_5d_.repeat<8>().val(), 0);
		}
	}
	// cells $flatten\unity_link_inst.\with_fifo_fifo_port_inst.$procdff$4392 $flatten\unity_link_inst.\with_fifo_fifo_port_inst.$and$top.v:12200$3250 $flatten\unity_link_inst.\with_fifo_fifo_port_inst.$not$top.v:12198$3249
	if (posedge_p_clk) {
		p_out__flush.next = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_flush.curr, not_u<1>(p_rst));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4403 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12121$3226 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12067$3199 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$add$top.v:12065$3198
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n333__q.next = (p_rst ? value<8>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n333__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n333__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4402 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12123$3227 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12071$3201 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$add$top.v:12069$3200
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n334__q.next = (p_rst ? value<8>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n334__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n334__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4401 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12125$3228 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12115$3223 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$add$top.v:12093$3212 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12109$3220 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$sub$top.v:12103$3217
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n286__o ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<1>{0x1u}) : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o ? sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4400 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12127$3229 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12117$3224 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12107$3219 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12111$3221
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n286__o ? value<1>{0x1u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n276__o, p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4399 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12129$3230 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12119$3225 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12097$3214 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$eq$top.v:12095$3213 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12113$3222
	if (posedge_p_clk) {
		p_in__ready.next = (p_rst ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n286__o ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<8>{0xffu}) ? value<1>{0u} : p_in__ready.curr) : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o ? value<1>{0x1u} : p_in__ready.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4398 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12131$3231 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12085$3208
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n279__o ? p_in__lost.concat(p_in__data).val() : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4397 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12133$3232 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12087$3209 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12083$3207
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n341__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n279__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n341__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4396 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$3274
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n342__data.next = (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o ? i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_12159_24_3241__DATA : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n342__data.curr);
	}
	// cells $flatten\unity_link_inst.\wishbone_master_inst.$or$top.v:12246$3252 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6281$2136 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6279$2135 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$or$top.v:6277$2134
	p_wb__cyc = or_uu<1>(p_wb__stb.curr, and_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3643__q.curr, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.curr), not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.curr)));
	// cells $flatten\unity_link_inst.\core_inst.\rx_register_inst.$procdff$4405 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:11959$3191 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:11955$3189
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_character__valid.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_fifo__out__ready ? p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr : p_unity__link__inst_2e_core__inst_2e_character__valid.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_register_inst.$procdff$4404 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:11957$3190 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:11953$3188 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12063$3197
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_character__in.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_fifo__out__ready ? (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n341__q.curr ? p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.curr : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n342__data.curr) : p_unity__link__inst_2e_core__inst_2e_character__in.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$procdff$4406 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11913$3182 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11911$3181 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11909$3180 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11511$3081 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11515$3082 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11519$3083 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11523$3084 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11527$3085 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11532$3086 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11398$3061 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11396$3060 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11906$3179 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11878$3173 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11882$3174 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11873$3172 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11867$3170 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$sub$top.v:11861$3168 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11857$3167 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:11869$3171 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11738$3144 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11887$3175 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11891$3176 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11895$3177 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:11900$3178
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.next = (p_rst ? value<62>{0u,0x1020u} : (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_advance ? (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<41>().val() ? (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n395__o ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<39>().val() ? value<4>{0x9u} : value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<38>().val() ? value<3>{0x7u} : value<3>{0u})).val())).concat(value<2>{0x3u}).val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<61,56>().concat(value<1>{0u}).val()).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n395__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n504__o)).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n395__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<53,46>().val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<7,0>().val())).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n395__o ? value<20>{0x40800u} : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<45,42>().concat(value<1>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<40,26>()).val())).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n395__o ? value<10>{0u} : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n503__o.concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<17>()).val())).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<15,8>()).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n395__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<7,0>().val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<15,8>().val())).val() : (p_unity__link__inst_2e_core__inst_2e_character__valid.curr ? (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n545__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n767__o.slice<7,1>().val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<61,56>().concat(value<1>{0u}).val()).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n545__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n767__o.slice<0>().val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n872__o.slice<8>().val())).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n545__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<53,46>().val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n872__o.slice<7,0>().val())).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n545__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n764__o.slice<29,23>().val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<45,42>().concat(value<2>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n535__o).val())).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n545__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n764__o.slice<22,0>().val() : (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n775__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<38,26>().val() : (and_uu<1>((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n775__o ? value<1>{0u} : value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n875__o) ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<38>().val()).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n875__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<37,26>().val() : sub_uu<12>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<37,26>().val(), value<1>{0x1u}))).val()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n869__o.slice<25,16>()).val())).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n545__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<15,0>().val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n869__o.slice<15,0>().val())).val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<61,56>().concat(value<2>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<53,42>()).concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr.slice<40,0>()).val())) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n925__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procdff$4486 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1822$462 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1820$461 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$4270 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1696$443 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$and$top.v:1690$441 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1692$442 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1725$450 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$4263 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$sub$top.v:1718$448 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$4256 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1682$438 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1678$437 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4601 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$4249 $auto$opt_reduce.cc:131:opt_pmux$4701 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$4242 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1590$418 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1686$439 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1710$447 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$gt$top.v:1702$445 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$add$top.v:1706$446 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$4235 $auto$opt_reduce.cc:131:opt_pmux$4649 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$4228 $auto$opt_reduce.cc:131:opt_pmux$4721 $auto$opt_reduce.cc:131:opt_pmux$4647 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:1592$419
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.next = (p_rst ? value<26>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_advance ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4229__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4230__CMP).val()) ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<88>().val() ? value<1>{0x1u} : value<1>{0u}) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4231__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4232__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4233__CMP).val()) ? value<1>{0x1u} : value<1>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4233__CMP ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<14,13>().val() : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4229__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4230__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4231__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4232__CMP).val()) ? value<2>{0u} : value<2>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4229__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<88>().val() ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6204__o_5b_6_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<22,15>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4230__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<88>().val() ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<87,80>().val() : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<22,15>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4231__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<12,9>().val(), value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<12,9>().val())).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<12,9>()).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4232__CMP ? value<8>{0xdu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4233__CMP ? value<8>{0xau} : value<8>{0u})))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4230__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<92,91>().val() : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4229__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4231__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4232__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4233__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<14,13>().val() : value<2>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4229__CMP ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6286__o.slice<12,5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4230__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<88>().val() ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6327__o_5b_2_3a_0_5d_.slice<2>().concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6334__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6341__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6348__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6355__o_5b_2_3a_0_5d_.slice<2>()).concat((p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6320__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6355__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6355__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val())).val() : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<12,5>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4231__CMP ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<8,5>().concat(value<4>{0u}).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4232__CMP ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<12,5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4233__CMP ? value<8>{0u} : value<8>{0u})))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4229__CMP ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6286__o.slice<4,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4230__CMP ? value<2>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4231__CMP ? sub_uu<2>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<4,3>().val(), value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4232__CMP ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<4,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4233__CMP ? value<2>{0u} : value<2>{0u})))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4229__CMP ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6286__o.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4230__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<89>().val(), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<88>().val()) ? value<2>{0x1u}.concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<90>().val() ? value<1>{0x1u} : value<1>{0u})).val() : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4231__CMP ? (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6200__o ? value<3>{0x4u} : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4232__CMP ? value<3>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_4233__CMP ? value<3>{0x1u} : value<3>{0u})))))).val() : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4497 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1202$363 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1148$336 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$add$top.v:1146$335
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6543__q.next = (p_rst ? value<8>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6455__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6543__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6543__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4496 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1204$364 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1152$338 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$add$top.v:1150$337
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6544__q.next = (p_rst ? value<8>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_n198__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6544__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6544__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4495 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1206$365 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1196$360 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$add$top.v:1174$349 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1190$357 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$sub$top.v:1184$354
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6496__o ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<1>{0x1u}) : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6504__o ? sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procdff$4407 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10996$3051 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10983$3048 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10986$3049 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10989$3050
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.next = (p_rst ? value<142>{0x10u,0u,0u,0u,0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2082__o.slice<141,127>().concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2084__o ? value<2>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2082__o.slice<126,125>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2082__o.slice<124,17>()).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2084__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2082__o.slice<16>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2082__o.slice<15,12>()).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2084__o ? value<12>{0x10u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2082__o.slice<11,0>().val())).val());
	}
	// \src: top.v:9080.3-9082.40
	// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procdff$4411
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_memory__word.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2163__data_5b_31_3a_0_5d_;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$procdff$4498 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1028$323 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1024$321 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1020$319 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1016$317
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_flush.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6559__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6562__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6564__o ? value<1>{0x1u} : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$procdff$4499 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1034$326 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1026$322 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1022$320 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1018$318
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6594__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6559__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6562__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6564__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6594__q.curr))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$procdff$4500 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1032$325
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark.next = (p_rst ? value<2>{0u} : p_unity__link__inst_2e_core__inst_2e_tx__entry.slice<9,8>().val());
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$procdff$4501 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1030$324
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left.next = (p_rst ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_n198__o);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4483 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3842$1538
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5014__q.next = (p_rst ? value<11>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n4981__o);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4482 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3844$1539 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3824$1529 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5255$1777
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.next = (p_rst ? value<11>{0u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4298__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted) ? p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n4981__o : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4481 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3846$1540
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5016__q.next = (p_rst ? value<11>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n4985__o);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4480 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3838$1536 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$sub$top.v:3832$1533 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$sub$top.v:3830$1532
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__ring__room.next = (p_rst ? value<11>{0x400u} : sub_uu<11>(value<11>{0x400u}, sub_uu<11>(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5014__q.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5016__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4479 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3840$1537 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3836$1535 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ne$top.v:3834$1534
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available.next = (p_rst ? value<1>{0u} : (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n4985__o) ? value<1>{0x1u} : value<1>{0u}));
	}
	// \src: top.v:3864.3-3866.37
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4478
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__word.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_5c_n5021__data_5b_31_3a_0_5d_;
	}
	// \src: top.v:3483.3-3484.28
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procdff$4484
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6134__q.next = p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__word.curr;
	}
	// \src: top.v:9065.3-9066.28
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procdff$4412
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.next = p_unity__link__inst_2e_core__inst_2e_memory__word.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procdff$4413 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9060$2689 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3577 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8717$2629 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8804$2656 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8784$2650 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8772$2646 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8765$2644 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8762$2643 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8760$2642 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8819$2662 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8835$2666 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8850$2671 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8859$2674 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8856$2673 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3567 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7744$2348 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7742$2347 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7753$2350 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$sub$top.v:7749$2349 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3557 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3547 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3537 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3527 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8809$2658 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8790$2652 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8775$2647 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8756$2641 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$add$top.v:8753$2640 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$sub$top.v:8747$2638 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3517 $auto$opt_reduce.cc:131:opt_pmux$4679 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8838$2667 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8735$2635 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8728$2633 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7759$2352 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ge$top.v:7757$2351 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3507 $auto$opt_reduce.cc:131:opt_pmux$4677 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8720$2630 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3497 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3487 $auto$opt_reduce.cc:131:opt_pmux$4673 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8841$2668 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3477 $auto$opt_reduce.cc:131:opt_pmux$4671 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8845$2669 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3467 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8800$2655 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8814$2660 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3457
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.next = (p_rst ? value<75>{0xd2000u,0x8000000u,0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4668 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<74>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3458__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3156__o.slice<4>().val() : value<1>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3461__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed, p_unity__link__inst_2e_core__inst_2e_access__done) ? p_unity__link__inst_2e_core__inst_2e_access__failure.curr : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<73,70>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4670 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<73,70>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3458__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3156__o.slice<3,0>().val() : value<4>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3463__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3256__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<69,62>().concat(value<1>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<54,47>().concat(value<1>{0x1u}).val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3458__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3459__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3460__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3461__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3462__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3464__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3465__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<69,62>().concat(value<1>{0u}).val() : value<9>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3463__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3256__o ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<60,58>().val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3459__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3460__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3461__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3462__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3464__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3465__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<60,58>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3458__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3154__o.slice<4,2>().val() : value<3>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3461__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3242__o.slice<1>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4670 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<57>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3458__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3154__o.slice<1>().val() : value<1>{0u})))).concat((reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3462__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3463__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3464__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3465__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<56>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3461__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3242__o.slice<0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3460__CMP ? value<1>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3459__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<55>().val() ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<56>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3458__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3154__o.slice<0>().val() : value<1>{0u})))))).concat((ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.curr, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<141,134>().val()) ? value<1>{0x1u} : value<1>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3463__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3256__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<54,47>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3176__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3461__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<18>().val(), p_unity__link__inst_2e_core__inst_2e_access__granted) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3176__o : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<54,47>().val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3459__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3460__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3462__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3464__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3465__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<54,47>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3458__CMP ? value<8>{0u} : value<8>{0u}))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3461__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__done ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<46,31>().val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2251__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<46,31>().val() : sub_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<46,39>().val(), value<1>{0x1u}).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<38,31>().val() : add_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<38,31>().val(), value<1>{0x1u}))).val())) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<46,31>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4670 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<46,31>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3458__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3153__o.slice<30,15>().val() : value<16>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4668 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<30,21>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3458__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3153__o.slice<14,5>().val() : value<10>{0u}))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4668 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<20>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3458__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3153__o.slice<4>().val() : value<1>{0u}))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4668 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<19,16>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3458__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3153__o.slice<3,0>().val() : value<4>{0u}))).concat(not_u<1>(sub_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<24,17>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<10,3>().val()).slice<7>().val())).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<24,17>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<10,3>().val()) ? value<1>{0x1u} : value<1>{0u})).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4668 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<13,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3458__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3151__o.slice<13,3>().val() : value<11>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3458__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3151__o.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3459__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<55>().val() ? value<3>{0x3u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3460__CMP ? value<3>{0x3u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3461__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__done ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? value<3>{0x7u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2251__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<19,16>().val(), value<3>{0x7u}) ? value<3>{0u} : value<3>{0x7u}) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val()))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3462__CMP ? (p_unity__link__inst_2e_core__inst_2e_group__done ? value<3>{0x5u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3463__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3256__o ? value<3>{0x6u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3464__CMP ? (p_unity__link__inst_2e_core__inst_2e_group__done ? value<3>{0x7u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3465__CMP ? (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_answer__taken, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<22>().val()) ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<2,0>().val()) : value<3>{0u}))))))))).val());
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4422 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6601$2225
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3434__q.next = (p_rst ? value<9>{0u} : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3401__o);
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4421 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6603$2226 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6583$2216 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7550$2284
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.next = (p_rst ? value<9>{0u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2323__o, p_unity__link__inst_2e_core__inst_2e_answer__taken) ? p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3401__o : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4420 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6605$2227 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6587$2218 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2419$737 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2417$736 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$add$top.v:6585$2217
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3436__q.next = (p_rst ? value<9>{0u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word, not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<78>().val())) ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3436__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3436__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4419 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6597$2223 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$sub$top.v:6591$2220 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$sub$top.v:6589$2219
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.next = (p_rst ? value<9>{0x100u} : sub_uu<9>(value<9>{0x100u}, sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3434__q.curr, p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3436__q.curr)));
	}
	// \src: top.v:6623.3-6625.37
	// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4417
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3441__data_5b_31_3a_0_5d_;
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4435 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6472$2192 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3830 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6309$2150 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6333$2162 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6323$2157
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3641__q.next = (p_rst ? value<2>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3801__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3520__o ? value<2>{0x1u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3641__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3802__CMP ? (p_unity__link__inst_2e_bus__done ? value<2>{0x2u} : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3538__o ? value<2>{0x2u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3641__q.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3803__CMP ? value<2>{0u} : value<2>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4434 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6474$2193 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3825 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6289$2140 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6283$2137
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.next = (p_rst ? value<1>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4652 ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3801__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr)) : value<1>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4433 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6476$2194 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3820 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6285$2138 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5193$1759 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5191$1758 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6341$2166 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6347$2169
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3643__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3801__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample ? (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4212__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4881__q.curr.slice<13,6>().val()) ? value<1>{0x1u} : value<1>{0u}) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3643__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3802__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3643__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3803__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3559__o) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3643__q.curr) : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4432 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6478$2195 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3815 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6291$2141 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6349$2170 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6343$2167
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3801__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? p_unity__link__inst_2e_core__inst_2e_access__more : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3802__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3803__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3559__o ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.curr : value<1>{0u}) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.curr) : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4431 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6480$2196 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3810 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6293$2142 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6287$2139 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7524$2273 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6351$2171 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6345$2168
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3801__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__more, or_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__write, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked)) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3802__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3803__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3559__o ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr : value<1>{0u}) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr) : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4430 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6482$2197 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3805 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6335$2163 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6325$2158
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3801__CMP ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3802__CMP ? (p_unity__link__inst_2e_bus__done ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.curr : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3538__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3803__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.curr : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4429 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6484$2198 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3800 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$sub$top.v:6313$2152
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q.next = (p_rst ? value<11>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3801__CMP ? value<11>{0x3ffu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3802__CMP ? sub_uu<11>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q.curr, value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3803__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q.curr : value<11>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4428 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6460$2186 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3860 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6327$2159 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6315$2153 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6319$2155
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_access__failure.next = (p_rst ? value<4>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3802__CMP ? (p_unity__link__inst_2e_bus__done ? value<1>{0u}.concat((p_wb__err ? value<3>{0x4u} : value<3>{0u})).val() : value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3538__o ? value<3>{0x5u} : value<3>{0u})).val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4660 ? p_unity__link__inst_2e_core__inst_2e_access__failure.curr : value<4>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4427 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6462$2187 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3855 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6329$2160
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.next = (p_rst ? value<32>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3802__CMP ? (p_unity__link__inst_2e_bus__done ? p_wb__dat__i : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4660 ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.curr : value<32>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4426 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6464$2188 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3850 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6301$2146 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6331$2161 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6321$2156
	if (posedge_p_clk) {
		p_wb__stb.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3801__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3520__o ? value<1>{0x1u} : p_wb__stb.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3802__CMP ? (p_unity__link__inst_2e_bus__done ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3538__o ? value<1>{0u} : p_wb__stb.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3803__CMP ? p_wb__stb.curr : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4425 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6466$2189 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3845 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6303$2147 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6297$2144
	if (posedge_p_clk) {
		p_wb__we.next = (p_rst ? value<1>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4652 ? p_wb__we.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3801__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3520__o ? and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__granted, p_unity__link__inst_2e_core__inst_2e_access__write) : p_wb__we.curr) : value<1>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4424 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6468$2190 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3840 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6305$2148 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6299$2145
	if (posedge_p_clk) {
		p_wb__adr.next = (p_rst ? value<8>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4652 ? p_wb__adr.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3801__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3520__o ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample__address.curr : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<38,31>().val()) : p_wb__adr.curr) : value<8>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4423 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6470$2191 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3835 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6307$2149 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7528$2274 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7460$2249 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7458$2248 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7538$2279 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7536$2278 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7534$2277 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7532$2276 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7530$2275
	if (posedge_p_clk) {
		p_wb__dat__o.next = (p_rst ? value<32>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4652 ? p_wb__dat__o.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3801__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3520__o ? ((or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2211__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2214__o) ? value<1>{0x1u} : value<1>{0u}) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.curr : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked ? or_uu<32>(and_uu<32>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.curr, not_u<32>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.curr)), and_uu<32>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<104,73>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.curr)) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<104,73>().val())) : p_wb__dat__o.curr) : value<32>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4494 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1208$366 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1198$361 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1188$356 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1192$358
	if (posedge_p_clk) {
		p_out__valid.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6496__o ? value<1>{0x1u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6486__o, p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6504__o) ? value<1>{0u} : p_out__valid.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4493 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1210$367 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1200$362 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1178$351 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$eq$top.v:1176$350 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1194$359
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_out__ready.next = (p_rst ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6496__o ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<8>{0xffu}) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_out__ready.curr) : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6504__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_out__ready.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4492 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1212$368 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1166$345
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.next = (p_rst ? value<10>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6489__o ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n6448__q.curr.slice<24,15>().val() : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4491 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1214$369 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1168$346 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1164$344
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6551__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6489__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_n198__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6551__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procdff$4485 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3478$1002 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3476$1001 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4169 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2782$854 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2998$920 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3084$940 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3174$960 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3262$981 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4160 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4151 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4142 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2954$908 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4133 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4124 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2965$910 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4115 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3181$963 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$sub$top.v:3163$957 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2564$775 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7704$2335 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7702$2334 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7696$2332 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7694$2331 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7700$2333 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3473$1000 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3471$999 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4106 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2568$776 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4097 $auto$opt_reduce.cc:131:opt_pmux$4725 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3086$941 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3000$921 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2785$855 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4088 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4079 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3186$965 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4070 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2661$811 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4224 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4225_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4226_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4216 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4217_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4218_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4219_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4220_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4221_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4222_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2943$906 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:2935$904 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:2939$905 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3039$930 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:3031$928 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:3035$929 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3125$950 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:3117$948 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:3121$949 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3225$974 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:3217$972 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:3221$973 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4061 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4052 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2787$856 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2989$916 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:3002$922 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3081$939 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:3088$942 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3176$961 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3264$982 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4043 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2572$778 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7738$2346 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7726$2341 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7736$2345 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:7732$2343 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2549$772 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2532$768
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.next = (p_rst ? value<93>{0u,0u,0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance ? (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4630 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<92,90>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4044__CMP ? (p_unity__link__inst_2e_core__inst_2e_answer__taken ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<13,12>().val(), value<1>{0x1u}) ? value<2>{0x2u} : value<1>{0u}.concat((reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<13,12>().val()) ? value<1>{0x1u} : value<1>{0u})).val()).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<21>()).val() : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5068__o ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6134__q.curr.slice<4>().val() ? value<2>{0x2u} : value<2>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6134__q.curr.slice<5>()).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<92,90>().val())) : value<3>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4044__CMP ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4045__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5464__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5514__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4046__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5514__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4047__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5505__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5099__o) ? value<1>{0x1u} : value<1>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4048__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5497__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5099__o) ? value<1>{0x1u} : value<1>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4049__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5974__o ? value<1>{0x1u} : value<1>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4050__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5099__o ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})))))))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4630 ? value<1>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4044__CMP ? value<1>{0u} : value<1>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4044__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<87,80>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4045__CMP ? value<2>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<8>()).concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<7>().val() ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5252__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5248__o).val(), value<1>{0x1u}) ? value<5>{0x18u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5252__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5248__o).val(), value<2>{0x2u}) ? value<5>{0xeu} : value<5>{0x10u})) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5338__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5329__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5320__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5311__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5302__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5281__o).val(), value<1>{0x1u}) ? value<5>{0x12u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5338__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5329__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5320__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5311__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5302__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5281__o).val(), value<2>{0x2u}) ? value<5>{0x17u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5338__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5329__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5320__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5311__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5302__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5281__o).val(), value<3>{0x4u}) ? value<5>{0x9u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5338__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5329__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5320__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5311__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5302__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5281__o).val(), value<4>{0x8u}) ? value<5>{0x8u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5338__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5329__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5320__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5311__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5302__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5281__o).val(), value<5>{0x10u}) ? value<5>{0x11u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5338__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5329__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5320__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5311__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5302__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5281__o).val(), value<6>{0x20u}) ? value<5>{0xbu} : value<5>{0x7u})))))))).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4046__CMP ? value<2>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5462__o).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4047__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5713__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5713__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5713__o).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4048__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5816__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5816__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5816__o).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4049__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5909__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5909__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5909__o).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4050__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6013__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6013__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6013__o).val()) : value<8>{0u})))))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4049__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5099__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<79>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4692 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<79>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4044__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5233__o.slice<1>().val() : value<1>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4630 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<78>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4044__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5233__o.slice<0>().val() : value<1>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4050__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5753__o : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4048__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4049__CMP).val()) ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5099__o ? value<6>{0x7u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5753__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4047__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5099__o ? value<3>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5504__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5753__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4046__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5513__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4045__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5464__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<77,72>().val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5513__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4044__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<77,72>().val() : value<6>{0u}))))))).concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<78>().val() ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6134__q.curr : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4716 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<67,40>().concat(value<4>{0u}).val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4638 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<71,40>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4044__CMP ? (p_unity__link__inst_2e_core__inst_2e_answer__taken ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<71,40>().val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5214__o.slice<40,9>().val()) : value<32>{0u}))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4049__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5099__o ? sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<39,31>().val(), value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<39,31>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4692 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<39,31>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4044__CMP ? (p_unity__link__inst_2e_core__inst_2e_answer__taken ? value<1>{0u}.concat((and_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<19,18>().val()), and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<74>().val()), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2395__o)) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<141,134>().val() : value<8>{0u})).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5214__o.slice<8,0>().val()) : value<9>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4044__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5226__o.slice<21,14>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4638 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<30,23>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4716 ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5138__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<26,23>().concat(value<4>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<30,23>().val()) : value<8>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4630 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<22,19>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4044__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5226__o.slice<13,10>().val() : value<4>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4044__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5226__o.slice<9,2>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4638 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<18,11>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4716 ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5115__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<14,11>().concat(value<4>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<18,11>().val()) : value<8>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4630 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<10,9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4044__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5226__o.slice<1,0>().val() : value<2>{0u}))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4630 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<8,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4044__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5223__o.slice<8,3>().val() : value<6>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4044__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5223__o.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4045__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5464__o ? value<3>{0x2u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5512__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4046__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5512__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4047__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5099__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5503__o : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4048__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5099__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5501__o : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4049__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5974__o ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4050__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5099__o ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr.slice<2,0>().val()) : value<3>{0u})))))))).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6133__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4490 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$4288
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6552__data.next = (p_unity__link__inst_2e_core__inst_2e_n198__o ? i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_1240_24_378__DATA : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6552__data.curr);
	}
	// \src: top.v:688.3-690.40
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4507
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6949__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6949__data_5b_7_3a_0_5d_;
	}
	// \src: top.v:685.3-687.37
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4508
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6947__data_5b_7_3a_0_5d_;
	}
	// \src: top.v:657.3-659.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4512
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6943__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6943__data_5b_15_3a_0_5d_;
	}
	// \src: top.v:629.3-631.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4516
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6939__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6939__data_5b_15_3a_0_5d_;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4517 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:566$143 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:563$142 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:556$140 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:554$139 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:561$141 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:552$138 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:545$136 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:543$135 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:550$137 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:541$134 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:534$132 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:532$131 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:539$133 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:530$130 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:523$128 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:521$127 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:528$129 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:519$126 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:512$124 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:510$123 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:517$125 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:508$122 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:501$120 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:499$119 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:506$121 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:497$118 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:490$116 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:488$115 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:495$117 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:486$114 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:479$112 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:477$111 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:484$113 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:475$110 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:468$108 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:466$107 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:473$109 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:464$106 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:457$104 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:455$103 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:462$105 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:453$102 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:446$100 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:444$99 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:451$101 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:442$98 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:435$96 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:433$95 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:440$97 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:431$94 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:424$92 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:422$91 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:429$93 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:420$90 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:413$88 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:411$87 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:418$89 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:409$86 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:402$84 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:400$83 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:407$85 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:398$82 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:391$80 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:389$79 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:396$81
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.next = (p_rst ? value<16>{0u} : (and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xfu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<15>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<15>().val())).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xeu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<14>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<14>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xdu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<13>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<13>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xcu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<12>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<12>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xbu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<11>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<11>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xau}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<10>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<10>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0x9u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<9>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<9>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0x8u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<8>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<8>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<3>{0x7u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<7>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<7>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<3>{0x6u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<6>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<6>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<3>{0x5u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<5>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<5>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<3>{0x4u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<4>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<4>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<2>{0x3u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<3>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<3>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<2>{0x2u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<2>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<2>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<1>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<1>().val()))).concat((and_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<0>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<0>().val()))).val());
	}
	// \src: top.v:604.3-605.28
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4518
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__losses.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6949__data.curr;
	}
	// \src: top.v:601.3-602.29
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4519
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6943__data.curr;
	}
	// \src: top.v:598.3-599.29
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4520
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6939__data.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4521 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:578$149
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.next = (p_rst ? value<4>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6926__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4522 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:576$148
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.next = (p_rst ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6925__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4523 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:574$147
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6926__q.next = (p_rst ? value<4>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6924__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4524 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:572$146
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6925__q.next = (p_rst ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6923__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4525 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:570$145 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:387$78 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:383$76 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$add$top.v:375$72
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6924__q.next = (p_rst ? value<4>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick.curr ? value<4>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6923__q.curr ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6924__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6924__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4526 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:568$144 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:385$77 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:379$74 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:381$75 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:377$73
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6923__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick.curr ? value<1>{0x1u} : (and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6924__q.curr, value<4>{0xfu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6923__q.curr) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6923__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$procdff$4502 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$ternary$top.v:955$307 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$ternary$top.v:951$305
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6602__o ? value<1>{0x1u} : value<1>{0u}));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$procdff$4503 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$ternary$top.v:957$308 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$ternary$top.v:953$306 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$sub$top.v:947$303
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6616__q.next = (p_rst ? value<6>{0x31u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6602__o ? value<6>{0x31u} : sub_uu<6>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6616__q.curr, value<1>{0x1u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4474 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4721$1598
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3691__q.next = (p_rst ? value<16>{0xffffu} : p_trigger);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4473 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4723$1599
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3692__q.next = (p_rst ? value<16>{0xffffu} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3691__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4472 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4725$1600
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3693__q.next = (p_rst ? value<16>{0xffffu} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3692__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4471 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5831$1976 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4016 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5446$1855 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5438$1851 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4030 $auto$opt_reduce.cc:131:opt_pmux$4645 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5464$1864 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5462$1863 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5460$1862 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5476$1870 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5472$1868 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5504$1884 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5500$1882 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5498$1881 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5496$1880 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5516$1890 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5690$1961
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4877__q.next = (p_rst ? value<3>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3927__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4887__q.curr ? value<3>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_group__request ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4027__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4028__CMP).val()) ? value<3>{0x7u} : value<3>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4877__q.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3928__CMP ? value<3>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3929__CMP ? (and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3359__q.curr.slice<60,58>().val(), value<2>{0x3u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4190__o) ? value<3>{0x6u} : value<3>{0x3u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3930__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4161__o ? value<2>{0x2u}.concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room ? value<1>{0u} : value<1>{0x1u})).val() : value<3>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3931__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3494__o ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3559__o ? value<3>{0x5u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4564__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4881__q.curr.slice<13,6>().val()) ? value<3>{0x5u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4877__q.curr)) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4877__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3932__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4190__o ? value<3>{0x7u} : value<3>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3933__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out ? value<3>{0x7u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4877__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3934__CMP ? value<3>{0u} : value<3>{0u})))))))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4470 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5833$1977 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4006 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5448$1856 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5329$1812 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5440$1852
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4878__q.next = (p_rst ? value<2>{0x2u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4642 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4878__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3927__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4887__q.curr ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4889__q.curr ? value<1>{0u} : value<1>{0x1u})).val() : (p_unity__link__inst_2e_core__inst_2e_group__request ? value<2>{0x2u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4878__q.curr)) : value<2>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4469 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5835$1978 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3996 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5450$1857 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5442$1853
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.next = (p_rst ? value<4>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4642 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3927__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4887__q.curr ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.curr : (p_unity__link__inst_2e_core__inst_2e_group__request ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().val() : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4879__q.curr)) : value<4>{0u})));
	}
	// \src: top.v:5860.3-5861.30
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4468
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4881__q.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4903__data.curr;
	}
	// \src: top.v:5863.3-5864.27
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4467
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4907__data.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4466 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5837$1979 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3986 $auto$opt_reduce.cc:131:opt_pmux$4639 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5692$1962 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5686$1959 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5684$1958 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5452$1858 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5444$1854 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4026 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5419$1847 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5417$1846 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5414$1845 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5412$1844 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5409$1843 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5406$1842 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5404$1841 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5401$1840 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5399$1839 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5396$1838 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5394$1837 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5391$1836 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5389$1835 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5386$1834 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5384$1833 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5381$1832 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5379$1831 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5376$1830 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5374$1829 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5371$1828 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5369$1827 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5366$1826 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5364$1825 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5361$1824 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5359$1823 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5356$1822 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5354$1821 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5351$1820 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5349$1819 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5346$1818 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5344$1817 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5341$1816 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5339$1815 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5337$1814
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.next = (p_rst ? value<16>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3933__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4340__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr : or_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4605__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4612__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4618__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4624__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4630__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4636__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4642__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4648__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4654__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4660__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4666__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4672__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4678__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4684__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4690__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4695__o).val())) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3928__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3929__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3930__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3931__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3932__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3934__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3927__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4887__q.curr ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr : (p_unity__link__inst_2e_core__inst_2e_group__request ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4027__CMP ? value<16>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4028__CMP ? and_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr, not_u<16>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().val(), value<4>{0xfu}) ? value<1>{0x1u} : value<1>{0u}).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().val(), value<4>{0xeu}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().val(), value<4>{0xdu}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().val(), value<4>{0xcu}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().val(), value<4>{0xbu}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().val(), value<4>{0xau}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().val(), value<4>{0x8u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().val(), value<3>{0x7u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().val(), value<3>{0x6u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().val(), value<3>{0x5u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().val(), value<3>{0x4u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().val(), value<2>{0x3u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().val(), value<2>{0x2u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().val(), value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u})).concat((logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,41>().val()) ? value<1>{0x1u} : value<1>{0u})).val())) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr)) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr)) : value<16>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4465 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5839$1980 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3976 $auto$opt_reduce.cc:131:opt_pmux$4635 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5688$1960 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5694$1963 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5602$1925
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.next = (p_rst ? value<16>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3933__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4340__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out) ? or_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4605__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4612__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4618__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4624__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4630__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4636__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4642__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4648__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4654__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4660__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4666__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4672__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4678__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4684__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4690__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4695__o).val()) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3927__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3928__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3929__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3930__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3931__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3932__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3934__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr : value<16>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4464 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4719$1597 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4717$1596 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4715$1595 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5084$1730 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5079$1728 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5074$1726 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5069$1724 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5064$1722 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5059$1720 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5054$1718 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5049$1716 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5044$1714 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5039$1712 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5034$1710 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5029$1708 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5024$1706 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5019$1704 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5014$1702 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5009$1700 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5004$1698 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:4713$1594 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4711$1593 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4709$1592 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4707$1591
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__trigger.next = (p_rst ? value<16>{0u} : and_uu<16>(or_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__trigger.curr, and_uu<16>(and_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3692__q.curr, not_u<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3693__q.curr)), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4884__q.curr)), not_u<16>(or_uu<16>((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3845__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o : value<1>{0u}).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3851__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3856__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3861__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3866__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3871__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3876__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3881__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3886__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3891__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3896__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3901__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3906__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3911__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3916__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3921__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o : value<1>{0u})).val(), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3924__o))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4463 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4900$1654 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4894$1651 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4884$1648 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4874$1645 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4864$1642 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4854$1639 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4844$1636 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4834$1633 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4824$1630 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4814$1627 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4804$1624 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4794$1621 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4784$1618 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4774$1615 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4764$1612 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4754$1609 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4744$1606
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4887__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<0>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<1>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<2>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<3>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<4>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<5>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<6>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<7>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<8>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<9>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<10>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<11>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<12>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<13>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<14>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<15>().val() ? value<1>{0x1u} : value<1>{0u})))))))))))))))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4462 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4902$1655 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4896$1652 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4886$1649 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4876$1646 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4866$1643 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4856$1640 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4846$1637 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4836$1634 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4826$1631 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4816$1628 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4806$1625 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4796$1622 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4786$1619 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4776$1616 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4766$1613 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4756$1610 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4746$1607
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4888__q.next = (p_rst ? value<4>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<0>().val() ? value<4>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<1>().val() ? value<4>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<2>().val() ? value<4>{0x2u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<3>().val() ? value<4>{0x3u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<4>().val() ? value<4>{0x4u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<5>().val() ? value<4>{0x5u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<6>().val() ? value<4>{0x6u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<7>().val() ? value<4>{0x7u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<8>().val() ? value<4>{0x8u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<9>().val() ? value<4>{0x9u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<10>().val() ? value<4>{0xau} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<11>().val() ? value<4>{0xbu} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<12>().val() ? value<4>{0xcu} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<13>().val() ? value<4>{0xdu} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<14>().val() ? value<4>{0xeu} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<15>().val() ? value<4>{0xfu} : value<4>{0u})))))))))))))))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4461 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4904$1656 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4898$1653 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4888$1650 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4878$1647 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4868$1644 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4858$1641 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4848$1638 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4838$1635 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4828$1632 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4818$1629 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4808$1626 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4798$1623 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4788$1620 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4778$1617 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4768$1614 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4758$1611 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4748$1608
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4889__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<0>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<0>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<1>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<1>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<2>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<2>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<3>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<3>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<4>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<4>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<5>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<5>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<6>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<6>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<7>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<7>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<8>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<8>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<9>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<9>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<10>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<10>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<11>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<11>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<12>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<12>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<13>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<13>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<14>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<14>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3698__o.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<15>().val() : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4889__q.curr)))))))))))))))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4460 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5841$1981 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3966 $auto$opt_reduce.cc:131:opt_pmux$4633
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost__kept.next = (p_rst ? value<8>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3928__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost.curr : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3927__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3929__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3930__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3931__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3932__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3933__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3934__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost__kept.curr : value<8>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4459 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5145$1738 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5141$1736
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4891__q.next = (p_rst ? value<32>{0u} : add_uu<32>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4891__q.curr, value<1>{0x1u}));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4458 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5843$1982 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3956 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5484$1874
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.next = (p_rst ? value<8>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3931__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4212__o : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4626 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3927__CMP ? value<8>{0u} : value<8>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4457 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5845$1983 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3946 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5506$1885
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4893__q.next = (p_rst ? value<8>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3931__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3494__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4564__o : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4893__q.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4626 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4893__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3927__CMP ? value<8>{0u} : value<8>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4456 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5847$1984 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3936 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5490$1877 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5508$1886 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5488$1876
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3931__CMP ? (and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__word.curr), p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3494__o) ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4626 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3927__CMP ? value<1>{0u} : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4455 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5849$1985 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3926 $auto$opt_reduce.cc:131:opt_pmux$4623 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5502$1883 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5510$1887 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5478$1871 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5474$1869
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3931__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3559__o, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3494__o) ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3930__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4161__o ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr : value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3928__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3929__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3932__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3933__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3934__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3927__CMP ? value<1>{0u} : value<1>{0u})))));
	}
	// \src: top.v:5902.3-5903.26
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4454
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__word.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__read.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4453 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5139$1735 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5137$1734 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$lt$top.v:5128$1733 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3864 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3865_CMP0 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3866_CMP0 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3867_CMP0 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3868_CMP0 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3869 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3874 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3879 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3884
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_group__is__set.next = (p_rst ? value<1>{0u} : (lt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<48,41>().val(), value<5>{0x10u}) ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,43>().val(), value<2>{0x3u}) ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3870__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3871__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<14>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3872__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<13>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3873__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<12>().val() : value<1>{0u})))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,43>().val(), value<2>{0x2u}) ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3870__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<11>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3871__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<10>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3872__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3873__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<8>().val() : value<1>{0u})))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,43>().val(), value<1>{0x1u}) ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3870__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<7>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3871__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<6>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3872__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3873__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<4>().val() : value<1>{0u})))) : (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2141__q.curr.slice<44,43>().val()) ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3870__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3871__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<2>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3872__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<1>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3873__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<0>().val() : value<1>{0u})))) : value<1>{0u})))) : value<1>{0u}));
	}
	// \src: top.v:5908.3-5909.29
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4452
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample__address.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_address__read.curr;
	}
	// \src: top.v:5930.3-5932.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4451
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4903__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4903__data_5b_13_3a_0_5d_;
	}
	// \src: top.v:5958.3-5960.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4447
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4907__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4907__data_5b_9_3a_0_5d_;
	}
	// \src: top.v:5968.3-5970.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4443
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_address__read.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4910__data_5b_7_3a_0_5d_;
	}
	// \src: top.v:5978.3-5980.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4439
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__read.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4913__data_5b_31_3a_0_5d_;
	}
	// connection
	p_out__data = p_unity__link__inst_2e_core__inst_2e_tx__entry.slice<7,0>().val();
	// connection
	p_wb__sel = value<4>{0xfu};
	return converged;
}

} // namespace cxxrtl_design

