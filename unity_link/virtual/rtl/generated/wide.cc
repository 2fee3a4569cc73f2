// b99e509f46f4c62b names what this was made from: unity_link_fifo in its configuration 'wide', by GHDL and Yosys 0.70.0.
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
// \src: top.v:14299.1-14392.10
struct p_unity__link__fifo : public module {
	// \hdlname: unity_link_inst core_inst request_executor_inst n3775_q
	// \src: top.v:7890.15-7890.22
	wire<107> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q;
	// \hdlname: unity_link_inst core_inst request_executor_inst ring_room
	// \src: top.v:7151.17-7151.26
	wire<9> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room;
	// \hdlname: unity_link_inst core_inst response_ring_inst n3852_q
	// \src: top.v:7061.13-7061.20
	wire<9> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3852__q;
	// \hdlname: unity_link_inst core_inst response_ring_inst n3850_q
	// \src: top.v:7059.13-7059.20
	wire<9> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3850__q;
	// \hdlname: unity_link_inst core_inst response_ring_inst committed
	// \src: top.v:7040.14-7040.23
	wire<9> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst n5623_q
	// \src: top.v:3913.14-3913.21
	wire<13> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5623__q;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst n5621_q
	// \src: top.v:3911.14-3911.21
	wire<13> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5621__q;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst committed
	// \src: top.v:3892.15-3892.24
	wire<13> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2557_q
	// \src: top.v:10206.15-10206.22
	wire<202> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n4065_q
	// \src: top.v:6702.14-6702.21
	wire<64> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4065__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n4063_q
	// \src: top.v:6700.14-6700.21
	wire<11> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4063__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n4062_q
	// \src: top.v:6699.7-6699.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4062__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n4060_q
	// \src: top.v:6697.7-6697.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4060__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n4059_q
	// \src: top.v:6696.7-6696.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4059__q;
	// \hdlname: unity_link_inst core_inst frame_writer_inst sample_word
	// \src: top.v:1947.18-1947.29
	wire<64> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__word;
	// \hdlname: unity_link_inst core_inst frame_writer_inst sample_available
	// \src: top.v:1946.11-1946.27
	wire<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available;
	// \hdlname: unity_link_inst core_inst frame_writer_inst response_word
	// \src: top.v:1945.18-1945.31
	wire<64> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word;
	// \hdlname: unity_link_inst core_inst bus_master_inst n4057_q
	// \src: top.v:6694.13-6694.20
	wire<2> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4057__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5472_q
	// \src: top.v:4732.13-4732.20
	wire<4> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5472__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5473_q
	// \src: top.v:4733.13-4733.20
	wire<2> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5473__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5474_q
	// \src: top.v:4734.13-4734.20
	wire<5> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5476_q
	// \src: top.v:4735.14-4735.21
	wire<14> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5476__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5479_q
	// \src: top.v:4737.14-4737.21
	wire<20> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5482_q
	// \src: top.v:4740.7-4740.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5482__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5483_q
	// \src: top.v:4741.13-4741.20
	wire<5> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5484_q
	// \src: top.v:4742.7-4742.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5484__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5485_q
	// \src: top.v:4743.7-4743.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5485__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5487_q
	// \src: top.v:4745.14-4745.21
	wire<32> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5487__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5488_q
	// \src: top.v:4746.13-4746.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5488__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5490_q
	// \src: top.v:4748.13-4748.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5490__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5496_q
	// \src: top.v:4752.13-4752.20
	wire<9> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5496__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5502_data
	// \src: top.v:4756.14-4756.24
	wire<14> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5502__data;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5506_data
	// \src: top.v:4757.13-4757.23
	wire<10> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5506__data;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n7066_q
	// \src: top.v:1520.14-1520.21
	wire<52> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst exclusive
	// \src: top.v:6602.8-6602.17
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive;
	// \hdlname: unity_link_inst core_inst bus_master_inst for_sample
	// \src: top.v:6599.8-6599.18
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6744_q
	// \src: top.v:2450.14-2450.21
	wire<64> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6744__q;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6743_q
	// \src: top.v:2449.15-2449.22
	wire<149> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst sample_address
	// \src: top.v:6583.18-6583.32
	wire<32> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample__address;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst kept_valid
	// \src: top.v:23.8-23.18
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst kept_index
	// \src: top.v:24.14-24.24
	wire<5> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst kept_divisor
	// \src: top.v:25.15-25.27
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst kept_counter
	// \src: top.v:26.15-26.27
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst kept_losses
	// \src: top.v:27.14-27.25
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__losses;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4110_q
	// \src: top.v:4090.14-4090.21
	wire<20> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4110__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4109_q
	// \src: top.v:4089.14-4089.21
	wire<20> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4109__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n7583_q
	// \src: top.v:204.7-204.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7583__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n7584_q
	// \src: top.v:205.13-205.20
	wire<5> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7584__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n7585_q
	// \src: top.v:206.7-206.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7585__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n7586_q
	// \src: top.v:207.13-207.20
	wire<5> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7586__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n7599_data
	// \src: top.v:214.14-214.24
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7599__data;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n7603_data
	// \src: top.v:215.14-215.24
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7603__data;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n7609_data
	// \src: top.v:217.13-217.23
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7609__data;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4108_q
	// \src: top.v:4088.14-4088.21
	wire<20> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4108__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst tick_inst n7234_q
	// \src: top.v:1027.13-1027.20
	wire<6> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n7234__q;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1338_q
	// \src: top.v:12020.15-12020.22
	wire<141> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst enough_room
	// \src: top.v:4061.8-4061.19
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst address_read
	// \src: top.v:4058.15-4058.27
	wire<32> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_address__read;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n7170_data
	// \src: top.v:1200.13-1200.23
	wire<10> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7170__data;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n7169_q
	// \src: top.v:1199.7-1199.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7169__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst last_word
	// \src: top.v:4057.15-4057.24
	wire<64> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__word;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n7162_q
	// \src: top.v:1194.13-1194.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7162__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n7161_q
	// \src: top.v:1193.13-1193.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7161__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst last_read
	// \src: top.v:4056.15-4056.24
	wire<64> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__read;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst bypass
	// \src: top.v:1153.14-1153.20
	wire<10> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst count
	// \src: top.v:1147.14-1147.19
	wire<9> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst failed
	// \src: top.v:4055.8-4055.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst changed
	// \src: top.v:4054.8-4054.15
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst n7212_q
	// \src: top.v:1080.7-1080.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n7212__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst asked
	// \src: top.v:4052.14-4052.19
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst count
	// \src: top.v:13031.14-13031.19
	wire<9> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst bypass
	// \src: top.v:13037.14-13037.20
	wire<9> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst lost_kept
	// \src: top.v:4049.14-4049.23
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost__kept;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst lost
	// \src: top.v:4048.14-4048.18
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n348_q
	// \src: top.v:13077.13-13077.19
	wire<8> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n348__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n349_q
	// \src: top.v:13078.13-13078.19
	wire<8> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n349__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n356_q
	// \src: top.v:13083.7-13083.13
	wire<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n356__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n357_data
	// \src: top.v:13084.13-13084.22
	wire<9> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n357__data;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst its_mark
	// \src: top.v:1060.14-1060.22
	wire<2> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst has_left
	// \src: top.v:1059.8-1059.16
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst tick
	// \src: top.v:4042.8-4042.12
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst due_by_trigger
	// \src: top.v:4033.15-4033.29
	wire<20> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__trigger;
	// \hdlname: unity_link_inst bus_request
	// \src: top.v:14142.8-14142.19
	wire<1> p_unity__link__inst_2e_bus__request;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst due_by_timer
	// \src: top.v:4032.15-4032.27
	wire<20> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst is_set
	// \src: top.v:4031.15-4031.21
	wire<20> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set;
	// \hdlname: unity_link_inst core_inst with_groups_ring_room
	// \src: top.v:13541.15-13541.36
	wire<13> p_unity__link__inst_2e_core__inst_2e_with__groups__ring__room;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst group_state
	// \src: top.v:4022.14-4022.25
	wire<10> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state;
	// \hdlname: unity_link_inst core_inst sent_ready
	// \src: top.v:13448.8-13448.18
	wire<1> p_unity__link__inst_2e_core__inst_2e_sent__ready;
	// \hdlname: unity_link_inst core_inst group_is_set
	// \src: top.v:13418.8-13418.20
	wire<1> p_unity__link__inst_2e_core__inst_2e_group__is__set;
	// \hdlname: unity_link_inst core_inst access_failure
	// \src: top.v:13416.14-13416.28
	wire<4> p_unity__link__inst_2e_core__inst_2e_access__failure;
	// \hdlname: unity_link_inst core_inst memory_word
	// \src: top.v:13396.15-13396.26
	wire<64> p_unity__link__inst_2e_core__inst_2e_memory__word;
	// \hdlname: unity_link_inst core_inst request_executor_inst memory_kept
	// \src: top.v:7194.15-7194.26
	wire<64> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept;
	// \hdlname: unity_link_inst core_inst character_valid
	// \src: top.v:13367.8-13367.23
	wire<1> p_unity__link__inst_2e_core__inst_2e_character__valid;
	// \hdlname: unity_link_inst core_inst character_in
	// \src: top.v:13366.14-13366.26
	wire<9> p_unity__link__inst_2e_core__inst_2e_character__in;
	// \hdlname: unity_link_inst core_inst fifo_out_valid
	// \src: top.v:13364.8-13364.22
	wire<1> p_unity__link__inst_2e_core__inst_2e_fifo__out__valid;
	// \hdlname: unity_link_inst core_inst flush
	// \src: top.v:13356.11-13356.16
	wire<1> p_unity__link__inst_2e_core__inst_2e_flush;
	// \hdlname: unity_link_inst wishbone_master_inst n238_q
	// \src: top.v:13295.7-13295.13
	wire<1> p_unity__link__inst_2e_wishbone__master__inst_2e_n238__q;
	// \src: top.v:14320.18-14320.26
	/*output*/ wire<64> p_wb__dat__o;
	// \src: top.v:14319.18-14319.24
	/*output*/ wire<32> p_wb__adr;
	// \src: top.v:14318.17-14318.23
	/*output*/ value<8> p_wb__sel;
	// \src: top.v:14317.11-14317.16
	/*output*/ wire<1> p_wb__we;
	// \src: top.v:14316.11-14316.17
	/*output*/ value<1> p_wb__stb;
	// \src: top.v:14315.11-14315.17
	/*output*/ value<1> p_wb__cyc;
	// \src: top.v:14314.11-14314.20
	/*output*/ wire<1> p_out__flush;
	// \src: top.v:14313.11-14313.20
	/*output*/ wire<1> p_out__valid;
	// \src: top.v:14312.17-14312.25
	/*output*/ value<8> p_out__data;
	// \src: top.v:14311.11-14311.19
	/*output*/ wire<1> p_in__ready;
	// \src: top.v:14310.11-14310.19
	/*input*/ value<1> p_wb__stall;
	// \src: top.v:14309.11-14309.17
	/*input*/ value<1> p_wb__err;
	// \src: top.v:14308.11-14308.17
	/*input*/ value<1> p_wb__ack;
	// \src: top.v:14307.18-14307.26
	/*input*/ value<64> p_wb__dat__i;
	// \src: top.v:14306.18-14306.25
	/*input*/ value<20> p_trigger;
	// \src: top.v:14305.11-14305.20
	/*input*/ value<1> p_out__ready;
	// \src: top.v:14304.11-14304.19
	/*input*/ value<1> p_in__valid;
	// \src: top.v:14303.11-14303.18
	/*input*/ value<1> p_in__lost;
	// \src: top.v:14302.17-14302.24
	/*input*/ value<8> p_in__data;
	// \src: top.v:14301.11-14301.14
	/*input*/ value<1> p_rst;
	// \src: top.v:14300.11-14300.14
	/*input*/ value<1> p_clk;
	value<1> prev_p_clk;
	bool posedge_p_clk() const {
		return !prev_p_clk.slice<0>().val() && p_clk.slice<0>().val();
	}
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6745
	// \src: top.v:3599.13-3599.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6745 { 64u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6747
	// \src: top.v:3669.13-3669.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6747 { 64u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6749
	// \src: top.v:3739.13-3739.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6749 { 64u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6751
	// \src: top.v:3809.13-3809.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6751 { 64u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst last
	// \src: top.v:6457.14-6457.18
	memory<64> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last { 16384u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst list
	// \src: top.v:6447.14-6447.18
	memory<32> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_list { 8192u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst state_memory
	// \src: top.v:6403.13-6403.25
	memory<10> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory { 32u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst settings_memory
	// \src: top.v:6359.14-6359.29
	memory<14> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory { 32u };
	// \hdlname: unity_link_inst core_inst tx_fifo_inst memory
	// \no_rw_check: 1
	// \src: top.v:1323.36-1323.42
	memory<10> memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory { 256u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst losses
	// \src: top.v:764.13-764.19
	memory<8> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses { 32u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst counters
	// \src: top.v:720.14-720.22
	memory<16> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters { 32u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst divisors
	// \src: top.v:676.14-676.22
	memory<16> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors { 32u };
	// \hdlname: unity_link_inst core_inst response_ring_inst memory
	// \src: top.v:7124.14-7124.20
	memory<64> memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory { 256u };
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst memory
	// \src: top.v:3976.14-3976.20
	memory<64> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_memory { 4096u };
	// \hdlname: unity_link_inst core_inst rx_fifo_inst memory
	// \no_rw_check: 1
	// \src: top.v:13207.36-13207.42
	memory<9> memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory { 256u };
	// \hdlname: unity_link_inst core_inst request_memory_inst memory
	// \src: top.v:9581.14-9581.20
	memory<64> memory_p_unity__link__inst_2e_core__inst_2e_request__memory__inst_2e_memory { 256u };

	p_unity__link__fifo(interior) {}
	p_unity__link__fifo() {
		reset();
	};

	void reset() override;

	bool eval(performer *performer = nullptr) override;

	template<class ObserverT>
	bool commit(ObserverT &observer) {
		bool changed = false;
		if (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3852__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3850__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5623__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5621__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4065__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4063__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4062__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4060__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4059__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__word.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4057__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5472__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5473__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5476__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5482__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5484__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5485__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5487__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5488__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5490__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5496__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5502__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5506__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6744__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample__address.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__losses.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4110__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4109__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7583__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7584__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7585__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7586__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7599__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7603__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7609__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4108__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n7234__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_address__read.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7170__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7169__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__word.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7162__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7161__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__read.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n7212__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost__kept.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n348__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n349__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n356__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n357__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__trigger.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_bus__request.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__ring__room.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_sent__ready.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_group__is__set.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_access__failure.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_memory__word.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_character__valid.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_character__in.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_flush.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_wishbone__master__inst_2e_n238__q.commit(observer)) changed = true;
		if (p_wb__dat__o.commit(observer)) changed = true;
		if (p_wb__adr.commit(observer)) changed = true;
		if (p_wb__we.commit(observer)) changed = true;
		if (p_out__flush.commit(observer)) changed = true;
		if (p_out__valid.commit(observer)) changed = true;
		if (p_in__ready.commit(observer)) changed = true;
		prev_p_clk = p_clk;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_list.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_memory.commit(observer)) changed = true;
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
	static const value<4> mem_init_1[64] {
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0xau},
		value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x6u}, value<4>{0x9u},
		value<4>{0x8u}, value<4>{0x9u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0xfu}, value<4>{0xfu},
		value<4>{0x4u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0xfu}, value<4>{0x7u}, value<4>{0xbu},
		value<4>{0xdu}, value<4>{0x1u}, value<4>{0x1u}, value<4>{0xcu},
		value<4>{0x4u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x3u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x0u}, value<4>{0x4u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_1), std::end(mem_init_1), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6745.data[0]);
	static const value<4> mem_init_2[64] {
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0xau},
		value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x6u}, value<4>{0x9u},
		value<4>{0x8u}, value<4>{0x9u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0xfu}, value<4>{0xfu},
		value<4>{0x4u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0xfu}, value<4>{0x7u}, value<4>{0xbu},
		value<4>{0xdu}, value<4>{0x1u}, value<4>{0x1u}, value<4>{0xcu},
		value<4>{0x4u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x3u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x0u}, value<4>{0x4u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_2), std::end(mem_init_2), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6747.data[0]);
	static const value<4> mem_init_3[64] {
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0xau},
		value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x6u}, value<4>{0x9u},
		value<4>{0x8u}, value<4>{0x9u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0xfu}, value<4>{0xfu},
		value<4>{0x4u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0xfu}, value<4>{0x7u}, value<4>{0xbu},
		value<4>{0xdu}, value<4>{0x1u}, value<4>{0x1u}, value<4>{0xcu},
		value<4>{0x4u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x3u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x0u}, value<4>{0x4u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_3), std::end(mem_init_3), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6749.data[0]);
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
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0xfu}, value<4>{0xfu},
		value<4>{0x4u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0xfu}, value<4>{0x7u}, value<4>{0xbu},
		value<4>{0xdu}, value<4>{0x1u}, value<4>{0x1u}, value<4>{0xcu},
		value<4>{0x4u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x3u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x0u}, value<4>{0x4u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_4), std::end(mem_init_4), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6751.data[0]);
	static const value<10> mem_init_5[32] {
		value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u},
		value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u},
		value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u},
		value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u},
		value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u},
		value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u},
		value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u},
		value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u},
	};
	std::copy(std::begin(mem_init_5), std::end(mem_init_5), &memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory.data[0]);
	static const value<14> mem_init_6[32] {
		value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u},
		value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u},
		value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u},
		value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u},
		value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u},
		value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u},
		value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u},
		value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u},
	};
	std::copy(std::begin(mem_init_6), std::end(mem_init_6), &memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory.data[0]);
	static const value<8> mem_init_7[32] {
		value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u},
		value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u},
		value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u},
		value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u},
		value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u},
		value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u},
		value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u},
		value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u},
	};
	std::copy(std::begin(mem_init_7), std::end(mem_init_7), &memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses.data[0]);
	static const value<16> mem_init_8[32] {
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
	};
	std::copy(std::begin(mem_init_8), std::end(mem_init_8), &memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters.data[0]);
	static const value<16> mem_init_9[32] {
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
	};
	std::copy(std::begin(mem_init_9), std::end(mem_init_9), &memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors.data[0]);
}

bool p_unity__link__fifo::eval(performer *performer) {
	bool converged = true;
	bool posedge_p_clk = this->posedge_p_clk();
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2014_o
	// \src: top.v:9913.13-9913.20
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2014__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2025_o
	// \src: top.v:9917.8-9917.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2025__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2031_o
	// \src: top.v:9920.8-9920.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2031__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2034_o
	// \src: top.v:9921.8-9921.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2034__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2037_o
	// \src: top.v:9922.8-9922.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2037__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4880_o
	// \src: top.v:4448.8-4448.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4880__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2056_o
	// \src: top.v:9932.14-9932.21
	value<9> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2056__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6363_o
	// \src: top.v:2261.14-2261.21
	value<6> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6363__o;
	// \src: top.v:3977.3-3979.37
	value<64> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_5c_n5628__data_5b_63_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3494_o
	// \src: top.v:7681.14-7681.21
	value<15> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3494__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3672_o
	// \src: top.v:7825.8-7825.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3672__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2092_o
	// \src: top.v:9966.16-9966.23
	value<177> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2092__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6880_o
	// \src: top.v:1410.15-1410.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_23_3a_22_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2095_o
	// \src: top.v:9969.8-9969.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2095__o;
	// \src: top.v:7125.3-7127.37
	value<64> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3857__data_5b_63_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2104_o
	// \src: top.v:9975.8-9975.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2104__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2111_o
	// \src: top.v:9981.8-9981.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2111__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2114_o
	// \src: top.v:9983.8-9983.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2114__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2115_o
	// \src: top.v:9984.8-9984.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2115__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2116_o
	// \src: top.v:9985.8-9985.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2116__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6002_o
	// \src: top.v:2126.8-2126.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6002__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4917_o
	// \src: top.v:4465.8-4465.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4917__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2173_o
	// \src: top.v:10007.8-10007.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2173__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2176_o
	// \src: top.v:10009.8-10009.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2176__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6323_o
	// \src: top.v:2240.13-2240.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6323__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2207_o
	// \src: top.v:10026.8-10026.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2207__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2210_o
	// \src: top.v:10028.8-10028.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2210__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2216_o
	// \src: top.v:10032.8-10032.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2216__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2217_o
	// \src: top.v:10033.8-10033.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2217__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2220_o
	// \src: top.v:10035.8-10035.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2220__o;
	// \hdlname: unity_link_inst core_inst response_ring_inst n3817_o
	// \src: top.v:7046.14-7046.21
	value<9> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3817__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6320_o
	// \src: top.v:2237.8-2237.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6320__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2264_o
	// \src: top.v:10059.8-10059.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2264__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2266_o
	// \src: top.v:10060.8-10060.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2266__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2270_o
	// \src: top.v:10063.8-10063.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2270__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3484_o
	// \src: top.v:7673.8-7673.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3484__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6292_o
	// \src: top.v:2230.8-2230.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6292__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3592_o
	// \src: top.v:7768.14-7768.21
	value<8> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3592__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3475_o
	// \src: top.v:7670.8-7670.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3475__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5210_o
	// \src: top.v:4613.8-4613.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5210__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2308_o
	// \src: top.v:10077.8-10077.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2308__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2314_o
	// \src: top.v:10081.8-10081.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2314__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5216_o
	// \src: top.v:4616.8-4616.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5216__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2320_o
	// \src: top.v:10085.8-10085.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2320__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5222_o
	// \src: top.v:4619.8-4619.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5222__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5228_o
	// \src: top.v:4622.8-4622.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5228__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2361_o
	// \src: top.v:10107.8-10107.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2361__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2367_o
	// \src: top.v:10108.8-10108.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2367__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5234_o
	// \src: top.v:4625.8-4625.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5234__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2375_o
	// \src: top.v:10110.8-10110.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2375__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5240_o
	// \src: top.v:4628.8-4628.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5240__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2386_o
	// \src: top.v:10119.8-10119.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2386__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5246_o
	// \src: top.v:4631.8-4631.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5246__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5252_o
	// \src: top.v:4634.8-4634.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5252__o;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst n5592_o
	// \src: top.v:3901.15-3901.22
	value<13> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5592__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5257_o
	// \src: top.v:4637.8-4637.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5257__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2419_o
	// \src: top.v:10137.8-10137.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2419__o;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst n5588_o
	// \src: top.v:3898.15-3898.22
	value<13> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5588__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3132_o
	// \src: top.v:7463.15-7463.22
	value<12> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3132__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4273__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4272__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4271__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2478_o
	// \src: top.v:10169.14-10169.21
	value<10> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2478__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3128_o
	// \src: top.v:7460.14-7460.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3128__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4276_o
	// \src: top.v:4199.8-4199.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4276__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4283_o
	// \src: top.v:4200.8-4200.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4283__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2498_o
	// \src: top.v:10189.16-10189.23
	value<202> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2498__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4284_o
	// \src: top.v:4201.8-4201.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4284__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2500_o
	// \src: top.v:10191.8-10191.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2500__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3127_o
	// \src: top.v:7459.14-7459.21
	value<3> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3127__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4299_o
	// \src: top.v:4208.8-4208.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4299__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4301_o
	// \src: top.v:4209.8-4209.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4308_o
	// \src: top.v:4210.8-4210.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4308__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4314_o
	// \src: top.v:4213.8-4213.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4314__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3125_o
	// \src: top.v:7457.8-7457.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3125__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4319_o
	// \src: top.v:4216.8-4216.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3464_o
	// \src: top.v:7661.15-7661.22
	value<18> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3464__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4324_o
	// \src: top.v:4219.8-4219.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4324__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5948_o
	// \src: top.v:2111.8-2111.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5948__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5939_o
	// \src: top.v:2109.8-2109.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5939__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4329_o
	// \src: top.v:4222.8-4222.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4329__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5930_o
	// \src: top.v:2107.8-2107.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5930__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5921_o
	// \src: top.v:2105.8-2105.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5921__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5912_o
	// \src: top.v:2103.8-2103.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5912__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5911_o
	// \src: top.v:2102.8-2102.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5911__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5905_o
	// \src: top.v:2098.8-2098.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5905__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5902_o
	// \src: top.v:2096.8-2096.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5902__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4334_o
	// \src: top.v:4225.8-4225.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4334__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5891_o
	// \src: top.v:2093.8-2093.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5891__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5890_o
	// \src: top.v:2092.8-2092.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5890__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5887_o
	// \src: top.v:2090.8-2090.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5887__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3587_o
	// \src: top.v:7764.8-7764.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3587__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4339_o
	// \src: top.v:4228.8-4228.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4339__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3583_o
	// \src: top.v:7763.8-7763.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3583__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5862_o
	// \src: top.v:2082.8-2082.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5862__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5858_o
	// \src: top.v:2081.8-2081.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5858__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4344_o
	// \src: top.v:4231.8-4231.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4344__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5843_o
	// \src: top.v:2076.14-2076.21
	value<2> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5843__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4349_o
	// \src: top.v:4234.8-4234.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4349__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3928__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4354_o
	// \src: top.v:4237.8-4237.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4354__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5836_o
	// \src: top.v:2069.15-2069.22
	value<46> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5836__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5833_o
	// \src: top.v:2066.14-2066.21
	value<9> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5833__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4359_o
	// \src: top.v:4240.8-4240.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4359__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3929__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4364_o
	// \src: top.v:4243.8-4243.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4364__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3930__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5824_o
	// \src: top.v:2057.15-2057.22
	value<73> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5824__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4369_o
	// \src: top.v:4246.8-4246.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4369__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3931__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4374_o
	// \src: top.v:4249.8-4249.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4374__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3932__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4379_o
	// \src: top.v:4252.8-4252.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4379__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3933__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4384_o
	// \src: top.v:4255.8-4255.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4384__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3934__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4389_o
	// \src: top.v:4258.8-4258.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4389__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3935__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4394_o
	// \src: top.v:4261.8-4261.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4394__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4399_o
	// \src: top.v:4264.8-4264.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4399__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5746_o
	// \src: top.v:2026.8-2026.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5746__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4404_o
	// \src: top.v:4268.8-4268.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4404__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5733_o
	// \src: top.v:2021.8-2021.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5733__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5729_o
	// \src: top.v:2018.8-2018.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5729__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5204_o
	// \src: top.v:4610.8-4610.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5204__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4407_o
	// \src: top.v:4271.15-4271.22
	value<20> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4407__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5723_o
	// \src: top.v:2013.8-2013.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5723__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4411_o
	// \src: top.v:4274.8-4274.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5707_o
	// \src: top.v:2006.8-2006.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5707__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5704_o
	// \src: top.v:2004.8-2004.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5704__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5198_o
	// \src: top.v:4607.8-4607.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5198__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5192_o
	// \src: top.v:4604.8-4604.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5192__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3112_o
	// \src: top.v:7444.13-7444.20
	value<2> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3112__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5186_o
	// \src: top.v:4601.8-4601.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5186__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5675_o
	// \src: top.v:1985.8-1985.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5675__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5180_o
	// \src: top.v:4598.8-4598.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5180__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5653_o
	// \src: top.v:1971.8-1971.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5653__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5645_o
	// \src: top.v:1969.8-1969.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5645__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5174_o
	// \src: top.v:4595.8-4595.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5174__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst load_word
	// \src: top.v:1962.8-1962.17
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5168_o
	// \src: top.v:4592.8-4592.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5168__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst advance
	// \src: top.v:1959.8-1959.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5162_o
	// \src: top.v:4589.8-4589.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5162__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3106_o
	// \src: top.v:7438.13-7438.20
	value<3> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3106__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4535__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4534__CMP;
	// \src: top.v:802.3-804.40
	value<8> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n7609__data_5b_7_3a_0_5d_;
	// \src: top.v:799.3-801.37
	value<8> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n7607__data_5b_7_3a_0_5d_;
	// \src: top.v:3980.3-3982.37
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_3982_24_1687__EN_5b_63_3a_0_5d__24_1713_5b_0_5d_;
	// \src: top.v:755.3-757.42
	value<16> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n7603__data_5b_15_3a_0_5d_;
	// \src: top.v:711.3-713.42
	value<16> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n7599__data_5b_15_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5156_o
	// \src: top.v:4586.8-4586.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5156__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4740__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4739__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4738__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4737__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4736__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4688__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4687__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4686__CMP;
	// \src: top.v:6394.3-6396.45
	value<14> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n5502__data_5b_13_3a_0_5d_;
	// \src: top.v:6397.3-6399.42
	value<5> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_6399_24_1749__ADDR_5b_4_3a_0_5d__24_2274;
	// \src: top.v:6438.3-6440.42
	value<10> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n5506__data_5b_9_3a_0_5d_;
	// \src: top.v:6448.3-6450.35
	value<32> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n5509__data_5b_31_3a_0_5d_;
	// \src: top.v:6458.3-6460.35
	value<64> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n5512__data_5b_63_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3975_o
	// \src: top.v:6659.8-6659.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3975__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3973_o
	// \src: top.v:6658.8-6658.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3973__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6880_o
	// \src: top.v:1410.15-1410.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3954_o
	// \src: top.v:6648.8-6648.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3954__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3936_o
	// \src: top.v:6637.8-6637.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3936__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5150_o
	// \src: top.v:4583.8-4583.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5150__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n7037_o
	// \src: top.v:1502.8-1502.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7037__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n7028_o
	// \src: top.v:1500.8-1500.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7028__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n7023_o
	// \src: top.v:1499.8-1499.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7023__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5143_o
	// \src: top.v:4579.8-4579.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5143__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3910_o
	// \src: top.v:6623.8-6623.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3910__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3909_o
	// \src: top.v:6622.8-6622.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3909__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3902_o
	// \src: top.v:6621.8-6621.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3902__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6873_o
	// \src: top.v:1405.15-1405.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_12_3a_10_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6752_data
	// \src: top.v:2454.14-2454.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6752__data;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6873_o
	// \src: top.v:1405.15-1405.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_16_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3793__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6750_data
	// \src: top.v:2453.14-2453.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6750__data;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3881_o
	// \src: top.v:6610.8-6610.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3881__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3810__CMP;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3874_o
	// \src: top.v:6609.8-6609.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3874__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3817__CMP;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3871_o
	// \src: top.v:6608.8-6608.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3871__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3823__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6873_o
	// \src: top.v:1405.15-1405.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_23_3a_22_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3828__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3832__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6748_data
	// \src: top.v:2452.14-2452.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6748__data;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3835__CMP;
	// \hdlname: unity_link_inst core_inst bus_master_inst grant_sample
	// \src: top.v:6605.8-6605.20
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6746_data
	// \src: top.v:2451.14-2451.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6746__data;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3847__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6873_o
	// \src: top.v:1405.15-1405.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_26_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3848__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3849__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3850__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4798__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3859__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3860__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3861__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3862__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4799__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4800__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4801__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4803__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3871__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3872__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3873__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3874__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4411__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4804__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4410__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4409__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4408__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3883__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4805__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3884__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4407__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4406__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3891__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3892__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3893__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3894__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3895__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3896__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3897__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4405__CMP;
	// \hdlname: unity_link_inst core_inst bus_master_inst sample
	// \src: top.v:6581.11-6581.17
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4404__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4403__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4402__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4806__CMP;
	// \src: top.v:758.3-760.44
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_counters_24_top_2e_v_3a_760_24_66__EN_5b_15_3a_0_5d__24_241_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5102_o
	// \src: top.v:4560.14-4560.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5102__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst advance
	// \src: top.v:11529.8-11529.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_advance;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6880_o
	// \src: top.v:1410.15-1410.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_12_3a_10_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n410_o
	// \src: top.v:11547.8-11547.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n410__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst is_due
	// \src: top.v:29.8-29.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst counts
	// \src: top.v:31.8-31.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counts;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6880_o
	// \src: top.v:1410.15-1410.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_5_3a_4_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3662_o
	// \src: top.v:7820.8-7820.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3662__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6887_o
	// \src: top.v:1415.15-1415.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_26_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6887_o
	// \src: top.v:1415.15-1415.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_23_3a_22_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3441_o
	// \src: top.v:7639.15-7639.22
	value<18> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3441__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6887_o
	// \src: top.v:1415.15-1415.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_16_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4058__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6887_o
	// \src: top.v:1415.15-1415.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_12_3a_10_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n7294_o
	// \src: top.v:58.8-58.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7294__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6887_o
	// \src: top.v:1415.15-1415.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_8_3a_7_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6887_o
	// \src: top.v:1415.15-1415.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_5_3a_4_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6130_o
	// \src: top.v:2175.8-2175.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6130__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6887_o
	// \src: top.v:1415.15-1415.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6930_o
	// \src: top.v:1438.15-1438.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_26_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3572_o
	// \src: top.v:7756.14-7756.21
	value<5> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3572__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4115_o
	// \src: top.v:4092.15-4092.22
	value<20> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n563_o
	// \src: top.v:11639.8-11639.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n563__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n564_o
	// \src: top.v:11640.8-11640.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n564__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n578_o
	// \src: top.v:11649.8-11649.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n578__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4084__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6124_o
	// \src: top.v:2170.8-2170.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6124__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4091__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n631_o
	// \src: top.v:11660.8-11660.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n631__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6123_o
	// \src: top.v:2169.14-2169.21
	value<6> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6123__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n651_o
	// \src: top.v:11669.8-11669.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n651__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4093__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n697_o
	// \src: top.v:11688.8-11688.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n697__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4097__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6122_o
	// \src: top.v:2168.14-2168.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6122__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n717_o
	// \src: top.v:11697.8-11697.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n717__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4098__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4116__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n762_o
	// \src: top.v:11716.8-11716.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n762__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n782_o
	// \src: top.v:11725.8-11725.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n782__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n827_o
	// \src: top.v:11744.8-11744.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n827__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n847_o
	// \src: top.v:11753.8-11753.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n847__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4130__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n892_o
	// \src: top.v:11772.8-11772.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n892__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n912_o
	// \src: top.v:11781.8-11781.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n912__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4133__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5084_o
	// \src: top.v:4550.8-4550.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5084__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5082_o
	// \src: top.v:4549.8-4549.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5082__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n957_o
	// \src: top.v:11800.8-11800.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n957__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n977_o
	// \src: top.v:11809.8-11809.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n977__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5080_o
	// \src: top.v:4548.8-4548.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5080__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1022_o
	// \src: top.v:11828.8-11828.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1022__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1042_o
	// \src: top.v:11837.8-11837.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1042__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1087_o
	// \src: top.v:11856.8-11856.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1087__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1107_o
	// \src: top.v:11865.8-11865.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1107__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5069_o
	// \src: top.v:4543.8-4543.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5069__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1139_o
	// \src: top.v:11882.8-11882.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1139__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6115_o
	// \src: top.v:2161.8-2161.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6115__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6113_o
	// \src: top.v:2159.14-2159.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6113__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1173_o
	// \src: top.v:11904.15-11904.22
	value<61> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1173__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1176_o
	// \src: top.v:11907.14-11907.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1176__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3001_o
	// \src: top.v:7375.8-7375.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3001__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1184_o
	// \src: top.v:11912.8-11912.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1184__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1210_o
	// \src: top.v:11918.14-11918.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1210__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6111_o
	// \src: top.v:2157.14-2157.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6111__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst tick_inst n7220_o
	// \src: top.v:1022.8-1022.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n7220__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6107_o
	// \src: top.v:2156.8-2156.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6107__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1220_o
	// \src: top.v:11925.15-11925.22
	value<32> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1227_o
	// \src: top.v:11930.15-11930.22
	value<32> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1234_o
	// \src: top.v:11935.15-11935.22
	value<32> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1241_o
	// \src: top.v:11940.15-11940.22
	value<32> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1248_o
	// \src: top.v:11945.15-11945.22
	value<32> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n5048_o
	// \src: top.v:4530.8-4530.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5048__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1255_o
	// \src: top.v:11950.15-11950.22
	value<32> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1262_o
	// \src: top.v:11955.15-11955.22
	value<32> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2975_o
	// \src: top.v:7362.8-7362.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2975__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6880_o
	// \src: top.v:1410.15-1410.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_16_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1269_o
	// \src: top.v:11960.15-11960.22
	value<32> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2955_o
	// \src: top.v:7358.8-7358.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2955__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1272_o
	// \src: top.v:11963.15-11963.22
	value<32> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1272__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1273_o
	// \src: top.v:11964.8-11964.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1273__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6086_o
	// \src: top.v:2149.8-2149.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6086__o;
	// \src: top.v:9582.3-9584.40
	value<64> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2579__data_5b_63_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6081_o
	// \src: top.v:2147.8-2147.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6081__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1282_o
	// \src: top.v:11972.16-11972.23
	value<104> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1282__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6074_o
	// \src: top.v:2145.8-2145.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6074__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1285_o
	// \src: top.v:11975.14-11975.21
	value<9> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1285__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6072_o
	// \src: top.v:2144.14-2144.21
	value<5> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6072__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n1288_o
	// \src: top.v:11977.8-11977.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1288__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3570_o
	// \src: top.v:7754.14-7754.21
	value<5> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3570__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6059_o
	// \src: top.v:2140.8-2140.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6059__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3569_o
	// \src: top.v:7753.15-7753.22
	value<59> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3569__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6050_o
	// \src: top.v:2138.8-2138.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6050__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3567_o
	// \src: top.v:7751.15-7751.22
	value<18> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3567__o;
	// \src: top.v:805.3-807.40
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_losses_24_top_2e_v_3a_807_24_99__EN_5b_7_3a_0_5d__24_252_5b_0_5d_;
	// \src: top.v:6461.3-6463.41
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_last_24_top_2e_v_3a_6463_24_1784__EN_5b_63_3a_0_5d__24_2303_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6623_o
	// \src: top.v:2379.13-2379.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6623__o;
	// \src: top.v:6441.3-6443.41
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_state__memory_24_top_2e_v_3a_6443_24_1782__EN_5b_9_3a_0_5d__24_2285_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6920_o
	// \src: top.v:1431.14-1431.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6920__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst accepted
	// \src: top.v:4063.8-4063.16
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6905_o
	// \src: top.v:1429.8-1429.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6905__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6900_o
	// \src: top.v:1425.15-1425.22
	value<39> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6900__o;
	// \src: top.v:6397.3-6399.42
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_6399_24_1749__EN_5b_13_3a_0_5d__24_2276_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst letter
	// \src: top.v:9624.8-9624.14
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter;
	// \hdlname: unity_link_inst core_inst request_decoder_inst digit
	// \src: top.v:9625.8-9625.13
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit;
	// \hdlname: unity_link_inst core_inst request_decoder_inst field
	// \src: top.v:9626.14-9626.19
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field;
	// \hdlname: unity_link_inst core_inst request_decoder_inst left
	// \src: top.v:9627.14-9627.18
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4589_o
	// \src: top.v:4351.8-4351.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4589__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6880_o
	// \src: top.v:1410.15-1410.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_26_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1361_o
	// \src: top.v:9631.8-9631.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1361__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4617_o
	// \src: top.v:4359.15-4359.22
	value<32> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4617__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6873_o
	// \src: top.v:1405.15-1405.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_5_3a_4_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6873_o
	// \src: top.v:1405.15-1405.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_8_3a_7_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6874_o
	// \src: top.v:1406.15-1406.22
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6874__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6873_o
	// \src: top.v:1405.15-1405.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6828_o
	// \src: top.v:1373.14-1373.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6828__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6810_o
	// \src: top.v:1369.8-1369.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6810__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4689_o
	// \src: top.v:4381.8-4381.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4689__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4692_o
	// \src: top.v:4382.8-4382.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4692__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4700_o
	// \src: top.v:4384.8-4384.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4700__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6764_o
	// \src: top.v:1354.8-1354.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6764__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4707_o
	// \src: top.v:4389.8-4389.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4707__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst advance
	// \src: top.v:1349.8-1349.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_advance;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4730_o
	// \src: top.v:4396.14-4396.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4730__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4741_o
	// \src: top.v:4399.8-4399.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4741__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4750_o
	// \src: top.v:4402.8-4402.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4750__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1412_o
	// \src: top.v:9650.8-9650.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4763_o
	// \src: top.v:4407.8-4407.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4763__o;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5123;
	// \src: top.v:6451.3-6453.37
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_list_24_top_2e_v_3a_6453_24_1783__EN_5b_31_3a_0_5d__24_2294_5b_0_5d_;
	// \src: top.v:1326.21-1326.27
	value<10> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_1326_24_540__DATA;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5125;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5139;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5151;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5159;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5163;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5165;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4340__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4341__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4342__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4343__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4858_o
	// \src: top.v:4442.8-4442.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4858__o;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5189;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5195;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1432_o
	// \src: top.v:9659.8-9659.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n7122_o
	// \src: top.v:1176.8-1176.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7122__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n7114_o
	// \src: top.v:1171.8-1171.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7114__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n7107_o
	// \src: top.v:1166.8-1166.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7107__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n7104_o
	// \src: top.v:1163.8-1163.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7104__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n7073_o
	// \src: top.v:1155.8-1155.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7073__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1444_o
	// \src: top.v:9664.8-9664.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1444__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4805_o
	// \src: top.v:4427.8-4427.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4805__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4812_o
	// \src: top.v:4428.8-4428.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4812__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6041_o
	// \src: top.v:2136.8-2136.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6041__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4828_o
	// \src: top.v:4434.8-4434.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4828__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1467_o
	// \src: top.v:9672.8-9672.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1467__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4850_o
	// \src: top.v:4440.8-4440.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4850__o;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5201;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4838_o
	// \src: top.v:4436.8-4436.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4838__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4557__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4556__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4555__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4554__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4553__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4552__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1472_o
	// \src: top.v:9675.14-9675.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1472__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1477_o
	// \src: top.v:9676.14-9676.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1477__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6584_o
	// \src: top.v:2362.8-2362.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6584__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4551__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n513_o
	// \src: top.v:11600.15-11600.21
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6032_o
	// \src: top.v:2134.8-2134.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6032__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2811_o
	// \src: top.v:7285.8-7285.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2811__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1532_o
	// \src: top.v:9696.8-9696.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1532__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1538_o
	// \src: top.v:9699.8-9699.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1538__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1541_o
	// \src: top.v:9700.8-9700.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1541__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1544_o
	// \src: top.v:9701.8-9701.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1544__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n506_o
	// \src: top.v:11595.15-11595.21
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n260_o
	// \src: top.v:13039.8-13039.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n260__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n261_o
	// \src: top.v:13040.8-13040.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n261__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n291_o
	// \src: top.v:13047.8-13047.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n291__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n294_o
	// \src: top.v:13050.8-13050.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n301_o
	// \src: top.v:13055.8-13055.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n301__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n309_o
	// \src: top.v:13060.8-13060.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n309__o;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst n7182_o
	// \src: top.v:1067.8-1067.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n7182__o;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst n7180_o
	// \src: top.v:1065.8-1065.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n7180__o;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst n7177_o
	// \src: top.v:1063.8-1063.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n7177__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1567_o
	// \src: top.v:9714.8-9714.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1567__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1570_o
	// \src: top.v:9717.8-9717.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1570__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n499_o
	// \src: top.v:11590.15-11590.21
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2785_o
	// \src: top.v:7270.8-7270.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2785__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1579_o
	// \src: top.v:9726.8-9726.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1579__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n492_o
	// \src: top.v:11585.15-11585.21
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2761_o
	// \src: top.v:7262.8-7262.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2761__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2758_o
	// \src: top.v:7260.8-7260.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2758__o;
	// \hdlname: unity_link_inst bus_done
	// \src: top.v:14148.8-14148.16
	value<1> p_unity__link__inst_2e_bus__done;
	// \src: top.v:13210.20-13210.26
	value<9> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_13210_24_3676__DATA;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6881_o
	// \src: top.v:1411.15-1411.22
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6881__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst clear_timer
	// \src: top.v:4034.15-4034.26
	value<20> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2739_o
	// \src: top.v:7251.8-7251.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2739__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n485_o
	// \src: top.v:11580.15-11580.21
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2732_o
	// \src: top.v:7250.8-7250.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2732__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2728_o
	// \src: top.v:7248.8-7248.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2728__o;
	// \hdlname: unity_link_inst core_inst n198_o
	// \src: top.v:13575.8-13575.14
	value<1> p_unity__link__inst_2e_core__inst_2e_n198__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n478_o
	// \src: top.v:11575.15-11575.21
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst carry_out
	// \src: top.v:4029.8-4029.17
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1662_o
	// \src: top.v:9768.8-9768.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1662__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1665_o
	// \src: top.v:9769.8-9769.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1665__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1668_o
	// \src: top.v:9770.8-9770.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1668__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1671_o
	// \src: top.v:9771.8-9771.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1674_o
	// \src: top.v:9772.8-9772.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1678_o
	// \src: top.v:9773.8-9773.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1678__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1681_o
	// \src: top.v:9774.8-9774.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1681__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6519_o
	// \src: top.v:2329.13-2329.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6519__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n471_o
	// \src: top.v:11570.15-11570.21
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1703_o
	// \src: top.v:9778.8-9778.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1703__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1706_o
	// \src: top.v:9779.8-9779.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1706__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1722_o
	// \src: top.v:9784.8-9784.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1722__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3540_o
	// \src: top.v:7724.15-7724.22
	value<18> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3540__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1728_o
	// \src: top.v:9786.8-9786.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1728__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2695_o
	// \src: top.v:7229.8-7229.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2695__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1752_o
	// \src: top.v:9792.8-9792.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1752__o;
	// \hdlname: unity_link_inst core_inst with_groups_ring_write
	// \src: top.v:13537.8-13537.30
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write;
	// \src: top.v:13211.3-13213.35
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_13213_24_3629__EN_5b_8_3a_0_5d__24_3680_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1758_o
	// \src: top.v:9794.8-9794.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1758__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1761_o
	// \src: top.v:9795.8-9795.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1761__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1764_o
	// \src: top.v:9796.8-9796.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1764__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n7249_o
	// \src: top.v:41.15-41.22
	value<5> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7249__o_5b_4_3a_0_5d_;
	// \src: top.v:9585.3-9587.41
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_9587_24_3023__EN_5b_63_3a_0_5d__24_3029_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3067_o
	// \src: top.v:7412.14-7412.21
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3067__o_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1780_o
	// \src: top.v:9800.8-9800.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1780__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2996_o
	// \src: top.v:7371.14-7371.21
	value<2> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2996__o_5b_1_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2972_o
	// \src: top.v:7361.14-7361.21
	value<3> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2972__o_5b_2_3a_0_5d_;
	// \src: top.v:7128.3-7130.37
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_7130_24_2543__EN_5b_63_3a_0_5d__24_2569_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6867_o
	// \src: top.v:1401.15-1401.22
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6867__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6866_o
	// \src: top.v:1400.15-1400.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6866_o
	// \src: top.v:1400.15-1400.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_5_3a_4_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6866_o
	// \src: top.v:1400.15-1400.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_8_3a_7_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6866_o
	// \src: top.v:1400.15-1400.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_12_3a_10_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6866_o
	// \src: top.v:1400.15-1400.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_16_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6866_o
	// \src: top.v:1400.15-1400.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_23_3a_22_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6866_o
	// \src: top.v:1400.15-1400.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_26_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2667_o
	// \src: top.v:7219.8-7219.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2667__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6860_o
	// \src: top.v:1396.15-1396.22
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6860__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6839_o
	// \src: top.v:1381.15-1381.22
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6839__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6859_o
	// \src: top.v:1395.15-1395.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6859_o
	// \src: top.v:1395.15-1395.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_5_3a_4_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1817_o
	// \src: top.v:9817.14-9817.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1817__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6859_o
	// \src: top.v:1395.15-1395.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_8_3a_7_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6859_o
	// \src: top.v:1395.15-1395.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_12_3a_10_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6859_o
	// \src: top.v:1395.15-1395.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_16_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1822_o
	// \src: top.v:9820.8-9820.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1822__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6859_o
	// \src: top.v:1395.15-1395.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_23_3a_22_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6859_o
	// \src: top.v:1395.15-1395.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_26_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6838_o
	// \src: top.v:1380.15-1380.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1826_o
	// \src: top.v:9823.8-9823.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1826__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6838_o
	// \src: top.v:1380.15-1380.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_5_3a_4_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6838_o
	// \src: top.v:1380.15-1380.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_8_3a_7_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6838_o
	// \src: top.v:1380.15-1380.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_12_3a_10_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6838_o
	// \src: top.v:1380.15-1380.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_16_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1832_o
	// \src: top.v:9827.8-9827.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1832__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6838_o
	// \src: top.v:1380.15-1380.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_23_3a_22_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1833_o
	// \src: top.v:9828.8-9828.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1833__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6838_o
	// \src: top.v:1380.15-1380.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_26_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6853_o
	// \src: top.v:1391.15-1391.22
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6853__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2642_o
	// \src: top.v:7209.8-7209.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2642__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6852_o
	// \src: top.v:1390.15-1390.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1837_o
	// \src: top.v:9831.8-9831.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1837__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6852_o
	// \src: top.v:1390.15-1390.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_5_3a_4_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6852_o
	// \src: top.v:1390.15-1390.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_8_3a_7_5d_;
	// \hdlname: unity_link_inst core_inst tx_entry
	// \src: top.v:13449.14-13449.22
	value<10> p_unity__link__inst_2e_core__inst_2e_tx__entry;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6852_o
	// \src: top.v:1390.15-1390.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_12_3a_10_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1841_o
	// \src: top.v:9834.8-9834.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1841__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6852_o
	// \src: top.v:1390.15-1390.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_16_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6852_o
	// \src: top.v:1390.15-1390.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_23_3a_22_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2630_o
	// \src: top.v:7205.8-7205.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2630__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6852_o
	// \src: top.v:1390.15-1390.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_26_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1845_o
	// \src: top.v:9837.8-9837.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1845__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6846_o
	// \src: top.v:1386.15-1386.22
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6846__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst answer_has_id
	// \src: top.v:13433.8-13433.21
	value<1> p_unity__link__inst_2e_core__inst_2e_answer__has__id;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6845_o
	// \src: top.v:1385.15-1385.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst answer_taken
	// \src: top.v:13428.8-13428.20
	value<1> p_unity__link__inst_2e_core__inst_2e_answer__taken;
	// \hdlname: unity_link_inst core_inst answer_valid
	// \src: top.v:13427.8-13427.20
	value<1> p_unity__link__inst_2e_core__inst_2e_answer__valid;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2627_o
	// \src: top.v:7203.8-7203.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2627__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6845_o
	// \src: top.v:1385.15-1385.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_5_3a_4_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6845_o
	// \src: top.v:1385.15-1385.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_8_3a_7_5d_;
	// \hdlname: unity_link_inst core_inst group_done
	// \src: top.v:13421.8-13421.18
	value<1> p_unity__link__inst_2e_core__inst_2e_group__done;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6845_o
	// \src: top.v:1385.15-1385.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_12_3a_10_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6845_o
	// \src: top.v:1385.15-1385.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_16_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6845_o
	// \src: top.v:1385.15-1385.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_23_3a_22_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6845_o
	// \src: top.v:1385.15-1385.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_26_5d_;
	// \hdlname: unity_link_inst core_inst access_done
	// \src: top.v:13410.8-13410.19
	value<1> p_unity__link__inst_2e_core__inst_2e_access__done;
	// \hdlname: unity_link_inst core_inst access_granted
	// \src: top.v:13409.8-13409.22
	value<1> p_unity__link__inst_2e_core__inst_2e_access__granted;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1856_o
	// \src: top.v:9846.8-9846.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1856__o;
	// \hdlname: unity_link_inst core_inst access_more
	// \src: top.v:13405.8-13405.19
	value<1> p_unity__link__inst_2e_core__inst_2e_access__more;
	// \hdlname: unity_link_inst core_inst access_write
	// \src: top.v:13404.8-13404.20
	value<1> p_unity__link__inst_2e_core__inst_2e_access__write;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6814_o
	// \src: top.v:1371.13-1371.20
	value<7> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6814__o_5b_6_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1858_o
	// \src: top.v:9847.8-9847.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1858__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1859_o
	// \src: top.v:9848.8-9848.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1859__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6979_o
	// \src: top.v:1473.15-1473.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6979_o
	// \src: top.v:1473.15-1473.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_5_3a_4_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6979_o
	// \src: top.v:1473.15-1473.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_8_3a_7_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6979_o
	// \src: top.v:1473.15-1473.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_12_3a_10_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6979_o
	// \src: top.v:1473.15-1473.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_16_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6979_o
	// \src: top.v:1473.15-1473.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_23_3a_22_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6979_o
	// \src: top.v:1473.15-1473.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_26_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6973_o
	// \src: top.v:1469.15-1469.22
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6973__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst failed
	// \src: top.v:7193.8-7193.14
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed;
	// \hdlname: unity_link_inst core_inst hold
	// \src: top.v:13378.8-13378.12
	value<1> p_unity__link__inst_2e_core__inst_2e_hold;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6972_o
	// \src: top.v:1468.15-1468.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6972_o
	// \src: top.v:1468.15-1468.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_5_3a_4_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3658_o
	// \src: top.v:7818.14-7818.21
	value<2> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3658__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6972_o
	// \src: top.v:1468.15-1468.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_8_3a_7_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6972_o
	// \src: top.v:1468.15-1468.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_12_3a_10_5d_;
	// \hdlname: unity_link_inst core_inst fifo_out_ready
	// \src: top.v:13365.8-13365.22
	value<1> p_unity__link__inst_2e_core__inst_2e_fifo__out__ready;
	// \hdlname: unity_link_inst core_inst request_executor_inst last_word
	// \src: top.v:7191.8-7191.17
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6972_o
	// \src: top.v:1468.15-1468.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_16_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6972_o
	// \src: top.v:1468.15-1468.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_23_3a_22_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6972_o
	// \src: top.v:1468.15-1468.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_26_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6966_o
	// \src: top.v:1464.15-1464.22
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6966__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst is_masked
	// \src: top.v:7189.8-7189.17
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6965_o
	// \src: top.v:1463.15-1463.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6965_o
	// \src: top.v:1463.15-1463.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_5_3a_4_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst is_queue
	// \src: top.v:7188.8-7188.16
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6965_o
	// \src: top.v:1463.15-1463.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_8_3a_7_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6965_o
	// \src: top.v:1463.15-1463.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_12_3a_10_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6965_o
	// \src: top.v:1463.15-1463.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_16_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6965_o
	// \src: top.v:1463.15-1463.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_23_3a_22_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6965_o
	// \src: top.v:1463.15-1463.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_26_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6959_o
	// \src: top.v:1459.15-1459.22
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6959__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1891_o
	// \src: top.v:9874.15-9874.22
	value<11> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1891__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6958_o
	// \src: top.v:1458.15-1458.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6958_o
	// \src: top.v:1458.15-1458.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_5_3a_4_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1895_o
	// \src: top.v:9876.8-9876.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6958_o
	// \src: top.v:1458.15-1458.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_8_3a_7_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6958_o
	// \src: top.v:1458.15-1458.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_12_3a_10_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6880_o
	// \src: top.v:1410.15-1410.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_8_3a_7_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6958_o
	// \src: top.v:1458.15-1458.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_16_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6014_o
	// \src: top.v:2130.8-2130.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6014__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6958_o
	// \src: top.v:1458.15-1458.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_23_3a_22_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6958_o
	// \src: top.v:1458.15-1458.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_26_5d_;
	// \hdlname: unity_link_inst wishbone_master_inst n224_o
	// \src: top.v:13286.8-13286.14
	value<1> p_unity__link__inst_2e_wishbone__master__inst_2e_n224__o;
	// \hdlname: unity_link_inst wishbone_master_inst n221_o
	// \src: top.v:13283.8-13283.14
	value<1> p_unity__link__inst_2e_wishbone__master__inst_2e_n221__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6952_o
	// \src: top.v:1454.15-1454.22
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6952__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6951_o
	// \src: top.v:1453.15-1453.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6951_o
	// \src: top.v:1453.15-1453.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_5_3a_4_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6951_o
	// \src: top.v:1453.15-1453.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_8_3a_7_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6951_o
	// \src: top.v:1453.15-1453.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_12_3a_10_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6951_o
	// \src: top.v:1453.15-1453.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_16_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6951_o
	// \src: top.v:1453.15-1453.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_23_3a_22_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6951_o
	// \src: top.v:1453.15-1453.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_26_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6945_o
	// \src: top.v:1449.15-1449.22
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6945__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6114_o
	// \src: top.v:2160.14-2160.21
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6114__o_5b_3_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6944_o
	// \src: top.v:1448.15-1448.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1937_o
	// \src: top.v:9891.8-9891.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1937__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6944_o
	// \src: top.v:1448.15-1448.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_5_3a_4_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1939_o
	// \src: top.v:9892.8-9892.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1939__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6944_o
	// \src: top.v:1448.15-1448.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_8_3a_7_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1940_o
	// \src: top.v:9893.8-9893.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6944_o
	// \src: top.v:1448.15-1448.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_12_3a_10_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1943_o
	// \src: top.v:9894.8-9894.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1943__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6944_o
	// \src: top.v:1448.15-1448.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_16_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6944_o
	// \src: top.v:1448.15-1448.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_23_3a_22_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6944_o
	// \src: top.v:1448.15-1448.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_26_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6938_o
	// \src: top.v:1444.15-1444.22
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6938__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6937_o
	// \src: top.v:1443.15-1443.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6937_o
	// \src: top.v:1443.15-1443.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_5_3a_4_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6937_o
	// \src: top.v:1443.15-1443.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_8_3a_7_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6937_o
	// \src: top.v:1443.15-1443.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_12_3a_10_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1969_o
	// \src: top.v:9902.8-9902.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1969__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6937_o
	// \src: top.v:1443.15-1443.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_16_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6426_o
	// \src: top.v:2287.13-2287.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6426__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6937_o
	// \src: top.v:1443.15-1443.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_23_3a_22_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6937_o
	// \src: top.v:1443.15-1443.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_26_5d_;
	// \src: top.v:1327.3-1329.35
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_1329_24_493__EN_5b_9_3a_0_5d__24_544_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3692_o
	// \src: top.v:7839.8-7839.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3692__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6931_o
	// \src: top.v:1439.15-1439.22
	value<27> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6931__o_5b_26_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6930_o
	// \src: top.v:1438.15-1438.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6930_o
	// \src: top.v:1438.15-1438.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_5_3a_4_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6930_o
	// \src: top.v:1438.15-1438.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_8_3a_7_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6930_o
	// \src: top.v:1438.15-1438.22
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_12_3a_10_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1997_o
	// \src: top.v:9911.8-9911.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1997__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6930_o
	// \src: top.v:1438.15-1438.22
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_16_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6930_o
	// \src: top.v:1438.15-1438.22
	value<2> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_23_3a_22_5d_;
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:12284$3439 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12282$3438 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12280$3437
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n651__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<63,60>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<63,60>().val(), value<3>{0x6u}));
	// \src: top.v:12266.19-12266.36
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12266$3432
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n631__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<63,60>().val(), value<2>{0x3u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:12344$3456 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12342$3455 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12340$3454
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n717__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<55,52>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<55,52>().val(), value<3>{0x6u}));
	// \src: top.v:12326.19-12326.36
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12326$3449
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n697__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<55,52>().val(), value<2>{0x3u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:12404$3473 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12402$3472 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12400$3471
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n782__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<47,44>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<47,44>().val(), value<3>{0x6u}));
	// \src: top.v:12386.19-12386.36
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12386$3466
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n762__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<47,44>().val(), value<2>{0x3u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:12464$3490 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12462$3489 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12460$3488
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n847__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<39,36>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<39,36>().val(), value<3>{0x6u}));
	// \src: top.v:12446.19-12446.36
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12446$3483
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n827__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<39,36>().val(), value<2>{0x3u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:12524$3507 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12522$3506 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12520$3505
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n912__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<31,28>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<31,28>().val(), value<3>{0x6u}));
	// \src: top.v:12506.19-12506.36
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12506$3500
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n892__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<31,28>().val(), value<2>{0x3u});
	// \src: top.v:12095.19-12095.34
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$xor$top.v:12095$3395
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1210__o = xor_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<103,96>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<7,0>().val());
	// \src: top.v:1569.20-1569.66
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1569$557
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6810__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<6,3>().val(), value<1>{0x1u});
	// \src: top.v:8397.20-8397.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8397$2744
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1467__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<3,0>().val(), value<4>{0xcu});
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$5036
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<23,22>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<12,10>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<8,7>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<5,4>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<2,0>()) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1210__o.slice<1>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<94,93>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<87>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<83,81>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<79,78>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<76,75>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<73,72>()).concat(value<1>{0u}).val());
	// connection
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<31,27>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<25,24>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<21,17>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<15,13>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<3>()) = p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1210__o.slice<6,2>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1210__o.slice<0>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<95>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<92,88>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<86,84>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<80>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<77>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<74>()).val();
	// \src: top.v:12108.19-12108.43
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12108$3397
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1210__o.slice<7>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1210__o.slice<0>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<95>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<23,22>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<92,88>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<86,84>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<12,10>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<80>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<8,7>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<77>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<5,4>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<74>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1220__o.slice<2,0>()).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1210__o.slice<1,0>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<95,72>()).concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4784 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4785_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1567$556
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6814__o_5b_6_3a_0_5d_ = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6810__o.concat(logic_not<1>(value<27>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<6,3>()).val())).val(), value<1>{0x1u}) ? value<7>{0x5au} : value<7>{0x30u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4974$1799 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:4972$1798
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o = and_uu<20>(or_uu<20>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__trigger.curr), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr);
	// \src: top.v:8407.20-8407.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8407$2747
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1444__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<3,0>().val(), value<4>{0xfu});
	// \src: top.v:10344.20-10344.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10344$3065
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1361__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<11,8>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:12584$3524 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12582$3523 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12580$3522
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n977__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<23,20>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<23,20>().val(), value<3>{0x6u}));
	// \src: top.v:12566.19-12566.36
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12566$3517
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n957__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<23,20>().val(), value<2>{0x3u});
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$5038
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<23,22>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<12,10>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<8,7>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<5,4>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<2,0>()) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// connection
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<31,27>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<25,24>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<21,17>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<15,13>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<3>()) = p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1210__o.slice<5,2>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<2>()).val();
	// \src: top.v:1582.20-1582.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$xor$top.v:1582$559
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6828__o = xor_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<38,31>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6814__o_5b_6_3a_0_5d_);
	// \src: top.v:1695.20-1695.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$xor$top.v:1695$583
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6920__o = xor_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<38,31>().val(), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<143,136>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10338$3063 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10336$3062 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10334$3061 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10330$3059
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1472__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<3>().val() ? (or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<2>().val()), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1467__o) ? value<4>{0x5u} : value<4>{0xau}) : value<4>{0x2u});
	// \src: top.v:12118.19-12118.43
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12118$3399
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1210__o.slice<6>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<23,22>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<12,10>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<8,7>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<5,4>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1227__o.slice<2,0>()).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val());
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$5068
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_2_3a_0_5d_) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6828__o.slice<1>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<29,28>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<22>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<18,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<14,13>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<11,10>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<8,7>()).concat(value<1>{0u}).val());
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$5084
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_2_3a_0_5d_) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6920__o.slice<1>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<29,28>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<22>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<18,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<14,13>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<11,10>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<8,7>()).concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10340$3064 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10318$3055
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1477__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<5>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1444__o) ? value<4>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1472__o);
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$5040
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<23,22>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<12,10>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<8,7>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<5,4>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<2,0>()) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// connection
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<31,27>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<25,24>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<21,17>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<15,13>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<3>()) = p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1210__o.slice<4,2>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<2>()).val();
	// \src: top.v:1597.20-1597.47
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1597$561
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6839__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6828__o.slice<7>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6828__o.slice<0>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<30>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<27,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<21,19>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6838__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6828__o.slice<1,0>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<30,7>()).concat(value<1>{0u}).val());
	// \src: top.v:1711.20-1711.47
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1711$585
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6931__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6920__o.slice<7>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6920__o.slice<0>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<30>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<27,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<21,19>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6930__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6920__o.slice<1,0>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<30,7>()).concat(value<1>{0u}).val());
	// \src: top.v:10346.20-10346.47
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10346$3066
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1361__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1477__o : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<11,8>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:12644$3541 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12642$3540 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12640$3539
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1042__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<15,12>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<15,12>().val(), value<3>{0x6u}));
	// \src: top.v:12626.20-12626.38
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12626$3534
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1022__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<15,12>().val(), value<2>{0x3u});
	// \src: top.v:12128.19-12128.43
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12128$3401
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1210__o.slice<5>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<23,22>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<12,10>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<8,7>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<5,4>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1234__o.slice<2,0>()).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val());
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$5070
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_2_3a_0_5d_) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6839__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6839__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6839__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6839__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6839__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6839__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6839__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$5086
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_2_3a_0_5d_) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6931__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6931__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6931__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6931__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6931__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6931__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6931__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// \src: top.v:8316.20-8316.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8316$2708
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2114__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<3,0>().val(), value<3>{0x7u});
	// \src: top.v:8314.20-8314.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8314$2707
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2111__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<3,0>().val(), value<3>{0x4u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10271$3042 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10269$3041 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10267$3040 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ge$top.v:10261$3038 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$le$top.v:10265$3039 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10257$3037 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10255$3036 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10251$3035 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10247$3034
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter = and_uu<1>(and_uu<1>(and_uu<1>((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1361__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<131>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<132>().val())), (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<129,125>().val(), value<5>{0x1au}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<129,125>().val(), value<3>{0x7u})) ? value<1>{0x1u} : value<1>{0u}));
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$5042
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<23,22>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<12,10>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<8,7>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<5,4>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<2,0>()) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// connection
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<31,27>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<25,24>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<21,17>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<15,13>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<3>()) = p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1210__o.slice<3,2>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<2>()).val();
	// \src: top.v:1607.20-1607.47
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1607$563
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6846__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6828__o.slice<6>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6839__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6839__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6839__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6839__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6839__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6839__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6845__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6839__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val());
	// \src: top.v:1721.20-1721.47
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1721$587
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6938__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6920__o.slice<6>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6931__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6931__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6931__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6931__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6931__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6931__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6937__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6931__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val());
	// \src: top.v:11333.20-11333.41
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11333$3328
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2361__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<16>().val() ? value<1>{0u} : value<1>{0x1u});
	// \src: top.v:8318.20-8318.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8318$2709
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2115__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2111__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2114__o);
	// \src: top.v:12138.19-12138.43
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12138$3403
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1210__o.slice<4>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<23,22>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<12,10>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<8,7>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<5,4>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1241__o.slice<2,0>()).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val());
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$5072
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_2_3a_0_5d_) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6846__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6846__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6846__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6846__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6846__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6846__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6846__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$5088
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_2_3a_0_5d_) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6938__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6938__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6938__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6938__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6938__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6938__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6938__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// \src: top.v:11393.20-11393.37
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:11393$3349
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2419__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2361__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2115__o);
	// \src: top.v:11070.20-11070.43
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:11070$3240
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2104__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<173,165>().val());
	// \src: top.v:8303.20-8303.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8303$2702
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1943__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<3,0>().val());
	// \src: top.v:8280.20-8280.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8280$2691
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1939__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<3,0>().val(), value<2>{0x2u});
	// \src: top.v:8278.20-8278.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8278$2690
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1937__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<3,0>().val(), value<1>{0x1u});
	// \src: top.v:7966.20-7966.38
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7966$2581
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2642__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<23,20>().val(), value<2>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:12704$3558 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12702$3557 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12700$3556
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1107__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<7,4>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<7,4>().val(), value<3>{0x6u}));
	// \src: top.v:12686.20-12686.38
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12686$3551
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1087__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<7,4>().val(), value<2>{0x3u});
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$5044
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<23,22>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<12,10>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<8,7>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<5,4>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<2,0>()) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// connection
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<31,27>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<25,24>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<21,17>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<15,13>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<3>()) = p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1210__o.slice<2>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<2>()).val();
	// \src: top.v:1617.20-1617.47
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1617$565
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6853__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6828__o.slice<5>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6846__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6846__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6846__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6846__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6846__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6846__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6852__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6846__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val());
	// \src: top.v:1731.20-1731.47
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1731$589
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6945__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6920__o.slice<5>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6938__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6938__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6938__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6938__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6938__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6938__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6944__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6938__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val());
	// \src: top.v:8305.20-8305.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8305$2703
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2216__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<3,0>().val(), value<2>{0x3u});
	// \src: top.v:11335.20-11335.41
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11335$3329
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2367__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<16>().val() ? value<1>{0u} : value<1>{0u});
	// \src: top.v:10748.20-10748.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10748$3164
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1858__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<4>{0x9u});
	// \src: top.v:10712.20-10712.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10712$3156
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1832__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<4>{0x8u});
	// \src: top.v:8282.20-8282.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8282$2692
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1937__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1939__o);
	// \src: top.v:7954.20-7954.38
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7954$2577
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2627__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<23,20>().val(), value<3>{0x5u});
	// \src: top.v:8072.20-8072.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8072$2621
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2761__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val(), value<3>{0x6u});
	// \src: top.v:8068.20-8068.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8068$2620
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2758__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val(), value<3>{0x4u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8014$2600 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:8012$2599
	p_unity__link__inst_2e_core__inst_2e_hold = (reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val()) ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:12148.19-12148.43
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12148$3405
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1210__o.slice<3>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<23,22>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<12,10>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<8,7>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<5,4>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1248__o.slice<2,0>()).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val());
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$5074
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_2_3a_0_5d_) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6853__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6853__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6853__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6853__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6853__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6853__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6853__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$5090
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_2_3a_0_5d_) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6945__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6945__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6945__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6945__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6945__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6945__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6945__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:11357$3336 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:11353$3335 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:11347$3333
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2386__o = or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1361__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<174>().val()), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2104__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<173>().val());
	// \src: top.v:10953.20-10953.37
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10953$3212
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1997__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1832__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1858__o);
	// \src: top.v:10746.20-10746.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10746$3163
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1856__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x4u});
	// \src: top.v:10732.20-10732.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10732$3160
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1845__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x7u});
	// \src: top.v:10726.20-10726.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10726$3159
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1841__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x6u});
	// \src: top.v:10720.20-10720.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10720$3158
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1837__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x5u});
	// \src: top.v:10704.20-10704.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10704$3154
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1826__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<2>{0x2u});
	// \src: top.v:10698.20-10698.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10698$3153
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1822__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<1>{0x1u});
	// \src: top.v:8333.20-8333.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8333$2716
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1969__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<3,0>().val(), value<4>{0x8u});
	// \src: top.v:7958.20-7958.38
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7958$2578
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2630__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<23,20>().val(), value<3>{0x6u});
	// \src: top.v:8348.20-8348.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8348$2723
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2266__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<3,0>().val(), value<4>{0xau});
	// \src: top.v:8341.20-8341.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8341$2720
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2264__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<3,0>().val(), value<4>{0x9u});
	// \src: top.v:8274.20-8274.54
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8274$2688
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2975__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<193>().val() ? value<1>{0u} : value<1>{0x1u});
	// \src: top.v:2575.20-2575.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2575$911
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5723__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<2,0>().val(), value<2>{0x3u});
	// \src: top.v:2561.20-2561.40
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2561$906
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5707__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<133,128>().val());
	// \src: top.v:10446.20-10446.28
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10446$3102
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1579__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<185>().val());
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$5046
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<23,22>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<12,10>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<8,7>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<5,4>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<2,0>()) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// connection
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<31,27>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<25,24>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<21,17>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<15,13>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<3>()) = p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<2>()).val();
	// \src: top.v:1627.20-1627.47
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1627$567
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6860__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6828__o.slice<4>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6853__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6853__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6853__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6853__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6853__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6853__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6859__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6853__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val());
	// \src: top.v:1741.20-1741.47
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1741$591
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6952__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6920__o.slice<4>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6945__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6945__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6945__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6945__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6945__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6945__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6951__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6945__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val());
	// \src: top.v:8322.20-8322.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8322$2711
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2207__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<3,0>().val(), value<3>{0x5u});
	// \src: top.v:11181.20-11181.64
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ge$top.v:11181$3278
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2220__o = ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<76,69>().val(), value<5>{0x14u});
	// \src: top.v:10390.20-10390.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10390$3083
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1544__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1477__o, value<3>{0x7u});
	// \src: top.v:10388.20-10388.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10388$3082
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1541__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1477__o, value<3>{0x4u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10386$3081 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10384$3080 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10382$3079
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1538__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1477__o, value<2>{0x2u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1477__o, value<4>{0x9u}));
	// \src: top.v:10380.20-10380.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10380$3078
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1532__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1477__o, value<1>{0x1u});
	// \src: top.v:1539.20-1539.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1539$550
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6764__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<2,0>().val(), value<1>{0x1u});
	// \src: top.v:8324.20-8324.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8324$2712
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2210__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<3,0>().val(), value<3>{0x6u});
	// \src: top.v:2557.20-2557.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2557$905
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5704__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<2,0>().val(), value<3>{0x5u});
	// \src: top.v:2585.20-2585.28
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2585$914
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5729__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<10>().val());
	// \src: top.v:5188.20-5188.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5188$1866
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4276__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5472__q.curr);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10428$3095 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10426$3094 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10418$3091 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10416$3090 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10414$3089 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:10412$3088 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10410$3087
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1570__o = not_u<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_hold, or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<134>().val(), and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter), (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u})))));
	// \src: top.v:10422.20-10422.28
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10422$3092
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1567__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<186>().val());
	// \src: top.v:12158.19-12158.43
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12158$3407
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1210__o.slice<2>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<23,22>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<12,10>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<8,7>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<5,4>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1255__o.slice<2,0>()).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val());
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$5076
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_2_3a_0_5d_) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6860__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6860__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6860__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6860__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6860__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6860__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6860__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$5092
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_2_3a_0_5d_) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6952__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6952__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6952__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6952__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6952__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6952__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6952__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// \src: top.v:11339.20-11339.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:11339$3331
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2375__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<4>{0xau});
	// \src: top.v:10750.20-10750.37
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10750$3165
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1859__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1856__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1858__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10714$3157 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10710$3155
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1833__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<2>{0x3u}), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1832__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3777 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3778_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3779_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3780_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3781_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3782_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3783_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3784_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10909$3190 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10929$3200 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10925$3198 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10921$3196 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10927$3199 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10923$3197 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10941$3206
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2014__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1997__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1845__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1841__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1837__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1856__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1826__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1822__o).val(), value<1>{0x1u}) ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1444__o ? value<4>{0xau} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1472__o) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1997__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1845__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1841__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1837__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1856__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1826__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1822__o).val(), value<2>{0x2u}) ? ((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1943__o ? value<1>{0u} : value<1>{0x1u})) ? value<4>{0x4u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o ? value<4>{0x3u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1943__o ? value<4>{0xau} : value<4>{0u}))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1997__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1845__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1841__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1837__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1856__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1826__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1822__o).val(), value<3>{0x4u}) ? value<4>{0x4u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1997__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1845__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1841__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1837__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1856__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1826__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1822__o).val(), value<4>{0x8u}) ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1969__o ? value<4>{0x6u} : value<4>{0xau}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1997__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1845__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1841__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1837__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1856__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1826__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1822__o).val(), value<5>{0x10u}) ? value<4>{0x7u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1997__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1845__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1841__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1837__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1856__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1826__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1822__o).val(), value<6>{0x20u}) ? value<4>{0x8u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1997__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1845__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1841__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1837__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1856__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1826__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1822__o).val(), value<7>{0x40u}) ? value<4>{0x9u} : value<4>{0xau})))))));
	// \src: top.v:8048.20-8048.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8048$2613
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2732__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val(), value<3>{0x7u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$or$top.v:1535$549 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$not$top.v:1533$548
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_advance = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<51>().val()), p_unity__link__inst_2e_core__inst_2e_sent__ready.curr);
	// \src: top.v:5510.20-5510.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5510$1983
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4692__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5472__q.curr, value<3>{0x6u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8390$2742 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8388$2741 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8386$2740
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2270__o = or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2264__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2266__o), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<3,0>().val(), value<4>{0xbu}));
	// \src: top.v:8326.20-8326.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8326$2713
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2320__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2207__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2210__o);
	// \src: top.v:8307.20-8307.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8307$2704
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2308__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1943__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2216__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8299$2700 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8295$2698 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8289$2695
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3001__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2975__o, logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.curr)), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2975__o);
	// \src: top.v:8272.20-8272.60
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8272$2687
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2972__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<193>().val() ? value<3>{0x6u} : value<3>{0u});
	// \src: top.v:2591.20-2591.43
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:2591$916
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5733__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<63,55>().val());
	// \src: top.v:2601.20-2601.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2601$920
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5746__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<2,0>().val(), value<3>{0x4u});
	// \src: top.v:5190.20-5190.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5190$1867
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4283__o = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4276__o ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:363.20-363.66
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$mod$top.v:363$111
	value<27>().concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7249__o_5b_4_3a_0_5d_) = mod_uu<32>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<5>{0x14u});
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$5048
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<23,22>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<12,10>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<8,7>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<5,4>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<2,0>()) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// connection
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<31,27>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<25,24>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<21,17>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<15,13>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<3>()) = p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<2>()).val();
	// \src: top.v:1637.20-1637.47
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1637$569
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6867__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6828__o.slice<3>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6860__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6860__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6860__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6860__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6860__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6860__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6866__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6860__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val());
	// \src: top.v:1751.20-1751.47
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1751$593
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6959__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6920__o.slice<3>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6952__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6952__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6952__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6952__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6952__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6952__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6958__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6952__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val());
	// \src: top.v:11128.20-11128.42
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:11128$3257
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2173__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<68,61>().val());
	// \full_case: 1
	// \src: top.v:10859.19-10859.19|top.v:10859.5-10868.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3793_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3793__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1859__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1845__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1841__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1837__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1833__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1826__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1822__o).val(), value<7>{0x40u});
	// \src: top.v:10539.20-10539.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10539$3122
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1681__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<129,125>().val(), value<3>{0x7u});
	// \src: top.v:10537.20-10537.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10537$3121
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1678__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<129,125>().val(), value<4>{0x9u});
	// \src: top.v:10535.20-10535.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10535$3120
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<129,125>().val(), value<4>{0xbu});
	// \src: top.v:10533.20-10533.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10533$3119
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<129,125>().val(), value<5>{0x11u});
	// \src: top.v:10531.20-10531.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10531$3118
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1668__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<129,125>().val(), value<4>{0x8u});
	// \src: top.v:10529.20-10529.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10529$3117
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1665__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<129,125>().val(), value<5>{0x17u});
	// \src: top.v:10527.20-10527.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10527$3116
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1662__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<129,125>().val(), value<5>{0x12u});
	// \src: top.v:10568.20-10568.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10568$3126
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1706__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<129,125>().val(), value<4>{0xdu});
	// \src: top.v:10591.20-10591.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10591$3132
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1728__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<129,125>().val(), value<5>{0x13u});
	// \src: top.v:10624.20-10624.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10624$3141
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1764__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<129,125>().val(), value<5>{0x10u});
	// \src: top.v:10622.20-10622.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10622$3140
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1761__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<129,125>().val(), value<5>{0x18u});
	// \src: top.v:10620.20-10620.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10620$3139
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1758__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<129,125>().val(), value<4>{0xeu});
	// \src: top.v:2728.20-2728.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2728$955
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5902__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<6,3>().val(), value<3>{0x5u});
	// \src: top.v:8050.20-8050.41
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8050$2614
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2739__o = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2732__o ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:2487.20-2487.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2487$884
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5645__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<2,0>().val());
	// \src: top.v:6741.20-6741.34
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:6741$2446
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3874__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4057__q.curr);
	// \src: top.v:5512.20-5512.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5512$1984
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4692__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:8416.38-8416.38|top.v:8412.5-8422.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4253_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4133__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1444__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1467__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2270__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1969__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2320__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2115__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2308__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o).val(), value<4>{0x8u});
	// \src: top.v:8918.20-8918.47
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8918$2895
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3441__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<193>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<17,3>().concat(value<3>{0x7u}).val() : value<3>{0x4u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<28,17>()).concat(value<3>{0x6u}).val());
	// \full_case: 1
	// \src: top.v:8415.38-8415.38|top.v:8412.5-8422.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4254_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4091__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1444__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1467__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2270__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1969__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2320__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2115__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2308__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:8419.38-8419.38|top.v:8412.5-8422.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4250_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4130__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1444__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1467__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2270__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1969__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2320__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2115__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2308__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:8414.38-8414.38|top.v:8412.5-8422.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4255_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4084__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1444__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1467__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2270__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1969__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2320__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2115__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2308__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:8418.38-8418.38|top.v:8412.5-8422.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4251_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4097__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1444__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1467__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2270__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1969__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2320__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2115__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2308__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o).val(), value<2>{0x2u});
	// \src: top.v:8368.20-8368.47
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8368$2732
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3067__o_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_group__is__set.curr ? value<1>{0u} : value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:8417.38-8417.38|top.v:8412.5-8422.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4252_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4098__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1444__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1467__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2270__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1969__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2320__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2115__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2308__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o).val(), value<3>{0x4u});
	// \src: top.v:8291.20-8291.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8291$2696
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2996__o_5b_1_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3001__o ? value<2>{0x1u} : value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:8412.19-8412.19|top.v:8412.5-8422.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4256_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4093__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1444__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1467__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2270__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1969__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2320__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2115__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2308__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o).val(), value<8>{0x80u});
	// \full_case: 1
	// \src: top.v:8959.38-8959.38|top.v:8958.5-8968.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4116_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4116__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1444__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1467__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2270__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1969__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2320__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2115__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2308__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o).val(), value<7>{0x40u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5192$1868 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5186$1865 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5184$1864 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5182$1863 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8076$2623 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8074$2622
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4284__o = and_uu<1>(and_uu<1>((or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2758__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2761__o) ? value<1>{0x1u} : value<1>{0u}), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5485__q.curr, not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5482__q.curr))), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4283__o);
	// \full_case: 1
	// \src: top.v:855.32-855.32|top.v:852.5-857.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4853_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4803__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7249__o_5b_4_3a_0_5d_.slice<1,0>().val(), value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:854.32-854.32|top.v:852.5-857.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4854_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4804__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7249__o_5b_4_3a_0_5d_.slice<1,0>().val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:853.32-853.32|top.v:852.5-857.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4855_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4805__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7249__o_5b_4_3a_0_5d_.slice<1,0>().val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:852.19-852.19|top.v:852.5-857.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4856_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4806__CMP = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7249__o_5b_4_3a_0_5d_.slice<1,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12784$3578 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:12778$3576 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:12782$3577
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1184__o = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<124>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<123>().val()));
	// \src: top.v:12168.19-12168.43
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12168$3409
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n471__o_5b_26_3a_0_5d_.slice<26>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<23,22>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<12,10>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<8,7>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<5,4>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1262__o.slice<2,0>()).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val());
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$5078
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_2_3a_0_5d_) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6867__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6867__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6867__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6867__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6867__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6867__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6867__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$5094
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_2_3a_0_5d_) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6959__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6959__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6959__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6959__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6959__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6959__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6959__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// \src: top.v:11132.20-11132.63
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:11132$3258
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2176__o = gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<68,61>().val(), value<8>{0xffu});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10406$3086 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3908 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3909_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3910_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3911_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3912_CMP0
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1361__o ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1544__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1541__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1538__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1532__o).val(), value<1>{0x1u}) ? value<4>{0x2u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1544__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1541__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1538__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1532__o).val(), value<2>{0x2u}) ? value<4>{0x7u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1544__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1541__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1538__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1532__o).val(), value<3>{0x4u}) ? value<4>{0xfu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1544__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1541__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1538__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1532__o).val(), value<4>{0x8u}) ? value<4>{0x3u} : value<4>{0x1u})))) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<15,12>().val());
	// \src: top.v:10982.20-10982.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10982$3219
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2037__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2014__o, value<3>{0x7u});
	// \src: top.v:10980.20-10980.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10980$3218
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2034__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2014__o, value<3>{0x4u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10978$3217 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10976$3216 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10974$3215
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2031__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2014__o, value<2>{0x2u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2014__o, value<4>{0x9u}));
	// \src: top.v:10972.20-10972.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10972$3214
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2025__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2014__o, value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10560.38-10560.38|top.v:10555.5-10564.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3892_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3892__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1681__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1678__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1668__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1665__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1662__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10561.38-10561.38|top.v:10555.5-10564.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3891_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3891__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1681__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1678__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1668__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1665__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1662__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10547.34-10547.34|top.v:10543.5-10552.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3902_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3893__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1681__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1678__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1668__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1665__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1662__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10546.34-10546.34|top.v:10543.5-10552.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3903_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3894__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1681__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1678__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1668__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1665__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1662__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10545.34-10545.34|top.v:10543.5-10552.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3904_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3895__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1681__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1678__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1668__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1665__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1662__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:10544.34-10544.34|top.v:10543.5-10552.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3905_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3896__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1681__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1678__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1668__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1665__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1662__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:10543.19-10543.19|top.v:10543.5-10552.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3906_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3897__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1681__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1678__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1668__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1665__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1662__o).val(), value<7>{0x40u});
	// \full_case: 1
	// \src: top.v:10581.19-10581.19|top.v:10581.5-10585.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3884_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3884__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1706__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10582.33-10582.33|top.v:10581.5-10585.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3883_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3883__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1706__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10608.19-10608.19|top.v:10608.5-10614.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3874_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3874__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1728__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1706__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10609.35-10609.35|top.v:10608.5-10614.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3873_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3873__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1728__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1706__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10610.35-10610.35|top.v:10608.5-10614.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3872_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3872__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1728__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1706__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10611.35-10611.35|top.v:10608.5-10614.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3871_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3871__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1728__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1706__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10637.19-10637.19|top.v:10637.5-10643.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3862_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3862__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1764__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1761__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1758__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1728__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10638.35-10638.35|top.v:10637.5-10643.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3861_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3861__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1764__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1761__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1758__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1728__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10639.35-10639.35|top.v:10637.5-10643.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3860_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3860__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1764__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1761__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1758__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1728__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10640.35-10640.35|top.v:10637.5-10643.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3859_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3859__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1764__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1761__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1758__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1728__o).val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8088$2625 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:8086$2624
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2785__o = (reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<105,102>().val()) ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:2720.20-2720.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2720$951
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5890__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<6,3>().val(), value<2>{0x2u});
	// \src: top.v:2732.20-2732.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2732$957
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5905__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<6,3>().val(), value<3>{0x6u});
	// \src: top.v:2716.20-2716.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2716$949
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5887__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<6,3>().val(), value<1>{0x1u});
	// \src: top.v:2865.20-2865.43
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2865$1001
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6107__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<63,55>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8100$2629 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:8098$2628
	p_unity__link__inst_2e_core__inst_2e_answer__valid = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2739__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<26>().val()));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2483$883 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$and$top.v:1543$552 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1541$551 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2481$882
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<144>().val()), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_advance, (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6764__o ? value<1>{0x1u} : value<1>{0u})));
	// \src: top.v:6743.20-6743.41
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6743$2447
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3881__o = (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3874__o ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6739$2445 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6747$2449
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3871__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample, not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr));
	// \src: top.v:5544.20-5544.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5544$1999
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4741__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5472__q.curr, value<3>{0x5u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7944$2575 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7940$2573
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<23,20>().val(), value<2>{0x3u}) ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:9049.20-9049.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:9049$2915
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3484__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1939__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2216__o);
	// \src: top.v:9043.20-9043.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:9043$2912
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3475__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1943__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1937__o);
	// \full_case: 1
	// \src: top.v:905.32-905.32|top.v:902.5-907.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4828_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4798__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7249__o_5b_4_3a_0_5d_.slice<3,2>().val(), value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:904.32-904.32|top.v:902.5-907.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4829_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4799__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7249__o_5b_4_3a_0_5d_.slice<3,2>().val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:903.32-903.32|top.v:902.5-907.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4830_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4800__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7249__o_5b_4_3a_0_5d_.slice<3,2>().val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:902.19-902.19|top.v:902.5-907.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4831_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4801__CMP = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7249__o_5b_4_3a_0_5d_.slice<3,2>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:12038$3387 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10452$3105 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10450$3104 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10448$3103 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10442$3101 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10440$3100 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:12036$3386
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_advance = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<133>().val()), and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1567__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1570__o), not_u<1>(and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<134>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<135>().val()), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1579__o))));
	// \src: top.v:12224.19-12224.35
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:12224$3420
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1139__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<118>().val(), p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<8>().val());
	// \src: top.v:12905.20-12905.48
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12905$3601
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1288__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<116,104>().val());
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$5050
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<23,22>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<12,10>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<8,7>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<5,4>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<2,0>()) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// connection
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<31,27>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<25,24>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<21,17>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<15,13>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<3>()) = p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<2>()).val();
	// \src: top.v:1647.20-1647.47
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1647$571
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6874__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6828__o.slice<2>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6867__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6867__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6867__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6867__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6867__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6867__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6873__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6867__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val());
	// \src: top.v:1761.20-1761.47
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1761$595
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6966__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6920__o.slice<2>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6959__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6959__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6959__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6959__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6959__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6959__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6965__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6959__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:11177$3277 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:11173$3275 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:11169$3273 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:11165$3271
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2217__o = or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2111__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2207__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2210__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2114__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2216__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10692$3152 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$add$top.v:10688$3151
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1817__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<131>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<128,125>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<128,125>().val());
	// \src: top.v:10883.20-10883.35
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10883$3180
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left);
	// \src: top.v:11008.20-11008.42
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$add$top.v:11008$3225
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2056__o = add_uu<9>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<173,165>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10879$3178 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10874$3177 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3792
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1891__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1826__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1837__o) ? value<11>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<175>().concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3793__CMP ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<174>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<173,165>()).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10301$3052 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10299$3051 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10297$3050
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<132,129>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<132,129>().val(), value<3>{0x6u}));
	// \src: top.v:10283.20-10283.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10283$3045
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<132,129>().val(), value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:10774.37-10774.37|top.v:10768.5-10777.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3835_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3835__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1859__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1845__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1841__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1837__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1833__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1826__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1822__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10786.37-10786.37|top.v:10781.5-10790.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3832_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3832__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1859__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1845__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1841__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1837__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1833__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1826__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1822__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10798.37-10798.37|top.v:10794.5-10803.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3828_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3828__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1859__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1845__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1841__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1837__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1833__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1826__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1822__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10810.37-10810.37|top.v:10807.5-10816.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3823_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3823__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1859__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1845__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1841__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1837__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1833__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1826__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1822__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10822.37-10822.37|top.v:10820.5-10829.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3817_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3817__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1859__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1845__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1841__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1837__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1833__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1826__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1822__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:10834.37-10834.37|top.v:10833.5-10842.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3810_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3810__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1859__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1845__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1841__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1837__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1833__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1826__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1822__o).val(), value<6>{0x20u});
	// \src: top.v:10645.20-10645.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10645$3144
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1780__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<4,0>().val(), value<5>{0x11u});
	// \src: top.v:10616.20-10616.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10616$3137
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1752__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<4,0>().val(), value<3>{0x4u});
	// \src: top.v:10587.20-10587.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10587$3130
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1722__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<4,0>().val());
	// \src: top.v:10566.20-10566.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10566$3125
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1703__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<4,0>().val(), value<5>{0x10u});
	// \src: top.v:8118.20-8118.28
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:8118$2631
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2811__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2785__o);
	// \src: top.v:2740.20-2740.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2740$961
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5911__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<6,3>().val(), value<2>{0x3u});
	// \src: top.v:2824.20-2824.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2824$993
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6059__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<6,3>().val(), value<4>{0xbu});
	// \src: top.v:2820.20-2820.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2820$991
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6050__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<6,3>().val(), value<4>{0xau});
	// \src: top.v:2816.20-2816.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2816$989
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6041__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<6,3>().val(), value<4>{0x9u});
	// \src: top.v:2812.20-2812.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2812$987
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6032__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<6,3>().val(), value<4>{0x8u});
	// \src: top.v:2804.20-2804.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2804$983
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6014__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5890__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5905__o);
	// \src: top.v:2796.20-2796.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2796$979
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6002__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5887__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5902__o);
	// \src: top.v:2875.20-2875.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2875$1006
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6115__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6107__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5729__o);
	// \src: top.v:2867.20-2867.45
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2867$1002
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6111__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6107__o ? value<3>{0u} : value<3>{0x5u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2491$886 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2489$885
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5653__o = and_uu<1>((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5645__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance);
	// \src: top.v:6745.20-6745.37
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6745$2448
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3871__o, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3881__o);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5508$1982 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5506$1981 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5504$1980
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4689__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5476__q.curr.slice<1>().val(), (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5473__q.curr, value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u}));
	// \src: top.v:6765.20-6765.34
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:6765$2458
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3902__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4057__q.curr, value<2>{0x2u});
	// \src: top.v:5524.20-5524.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5524$1989
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4707__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5473__q.curr, value<2>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7986$2588 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7984$2587
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2667__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked, not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<89>().val()));
	// \full_case: 1
	// \src: top.v:9103.33-9103.33|top.v:9101.5-9106.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4058_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4058__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2114__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3484__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3475__o).val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9027$2905 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4129 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4126 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4115
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3464__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<193>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<17,3>().concat(value<3>{0x7u}).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4116__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<70,69>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4093__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3441__o.slice<17,16>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<17,16>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4093__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3441__o.slice<15,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<15,3>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4130__CMP ? value<3>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4097__CMP ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2996__o_5b_1_3a_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4098__CMP ? value<3>{0x3u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4133__CMP ? value<3>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4091__CMP ? value<3>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4084__CMP ? value<2>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3067__o_5b_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4093__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3441__o.slice<2,0>().val() : value<3>{0x7u})))))))).val());
	// \src: top.v:8527.20-8527.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$add$top.v:8527$2760
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3132__o = add_uu<12>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<14,3>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8519$2758 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4090 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8371$2733 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8366$2731 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8362$2729
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3127__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<193>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<92,90>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4091__CMP ? value<3>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4084__CMP ? (p_unity__link__inst_2e_core__inst_2e_group__is__set.curr ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2264__o ? value<3>{0x1u} : value<2>{0x1u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2266__o ? value<1>{0u} : value<1>{0x1u})).val()) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<92,90>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4093__CMP ? value<3>{0x4u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<92,90>().val()))));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8516$2757 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4096 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8293$2697
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3125__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<193>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<88>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4097__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3001__o ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4098__CMP ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<88>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8521$2759 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4083 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8339$2719 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8380$2737 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8373$2734 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:8335$2717
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3128__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<193>().val() ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2972__o_5b_2_3a_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4084__CMP ? (and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2975__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_group__is__set.curr)), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2975__o) ? value<4>{0x6u} : value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2972__o_5b_2_3a_0_5d_).val()) : value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2972__o_5b_2_3a_0_5d_).val()));
	// \src: top.v:12228.19-12228.41
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12228$3422
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n563__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<7,0>().val(), value<4>{0xdu});
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$5080
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_2_3a_0_5d_) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6874__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6874__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6874__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6874__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6874__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6874__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6874__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$5096
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_2_3a_0_5d_) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6966__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6966__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6966__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6966__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6966__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6966__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6966__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:11277$3311 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:11273$3309
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2314__o = or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2308__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2111__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2114__o);
	// \full_case: 1
	// \src: top.v:10658.19-10658.19|top.v:10658.5-10664.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3850_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3850__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1780__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1752__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1722__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1703__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10659.34-10659.34|top.v:10658.5-10664.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3849_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3849__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1780__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1752__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1722__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1703__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10660.34-10660.34|top.v:10658.5-10664.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3848_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3848__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1780__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1752__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1722__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1703__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10661.34-10661.34|top.v:10658.5-10664.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3847_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3847__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1780__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1752__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1722__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1703__o).val(), value<1>{0x1u});
	// \src: top.v:2873.20-2873.51
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2873$1005
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6114__o_5b_3_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<10>().val() ? value<4>{0x1u} : value<4>{0xfu});
	// \src: top.v:3035.20-3035.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:3035$1064
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6320__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<2,0>().val(), value<3>{0x6u});
	// \src: top.v:2871.20-2871.46
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2871$1004
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6113__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<10>().val() ? value<3>{0x4u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6111__o);
	// \src: top.v:6767.20-6767.41
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6767$2459
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3909__o = (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3902__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:9069.33-9069.33|top.v:9067.5-9072.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4071
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3494__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4058__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3464__o.slice<17,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<17,3>().val());
	// \full_case: 1
	// \src: top.v:8702.38-8702.38|top.v:8701.5-8711.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4175
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3112__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4116__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<70,69>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4093__CMP ? value<2>{0x2u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<17,16>().val()));
	// \full_case: 1
	// \src: top.v:8419.38-8419.38|top.v:8412.5-8422.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4249
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3106__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4130__CMP ? value<3>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4097__CMP ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2996__o_5b_1_3a_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4098__CMP ? value<3>{0x3u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4133__CMP ? value<3>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4091__CMP ? value<3>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4084__CMP ? value<2>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3067__o_5b_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4093__CMP ? value<3>{0x6u} : value<3>{0x7u})))))));
	// \src: top.v:5776.20-5776.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5776$2089
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5048__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<92,90>().val(), value<2>{0x2u});
	// \src: top.v:5668.20-5668.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5668$2046
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4917__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<92,90>().val(), value<3>{0x4u});
	// \src: top.v:13110.19-13110.38
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:13110$3630
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n260__o = and_uu<1>(p_in__valid, p_in__ready.curr);
	// cells $flatten\unity_link_inst.\core_inst.\rx_register_inst.$or$top.v:12998$3620 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12044$3389 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:12042$3388 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$not$top.v:13000$3621
	p_unity__link__inst_2e_core__inst_2e_fifo__out__ready = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_character__valid.curr), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_advance, not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<120>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12244$3426 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:12238$3424 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12242$3425
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n578__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<116,104>().val(), value<13>{0x1005u}), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1139__o));
	// \src: top.v:12183.19-12183.39
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12183$3413
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1273__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<64>().val() ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12181$3412 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12178$3411
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1272__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<64>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n485__o_5b_26_3a_0_5d_.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n492__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n506__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<26>()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n478__o_5b_26_3a_0_5d_.slice<26>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<23,22>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<12,10>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<8,7>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<5,4>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1269__o.slice<2,0>()).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n513__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val())).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<103,72>().val());
	// \src: top.v:1657.20-1657.47
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1657$573
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6881__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6839__o_5b_26_3a_0_5d_.slice<26>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6874__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6874__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6874__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6874__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6874__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6874__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6880__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6874__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val());
	// \src: top.v:1771.20-1771.47
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1771$597
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6973__o_5b_26_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6931__o_5b_26_3a_0_5d_.slice<26>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6966__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6966__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6966__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6966__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6966__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6966__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6972__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6966__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:11090$3247 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:11078$3243 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:11072$3241 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:11066$3239 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:11062$3238 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:11076$3242
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2116__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2115__o, and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<6>().val()), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2104__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<174>().val(), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<11,8>().val(), value<3>{0x4u})))));
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3914 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3915_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3916_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10281$3044 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$le$top.v:10279$3043 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10295$3049 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10293$3048 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ge$top.v:10287$3046 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$le$top.v:10291$3047
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<128,125>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<128,125>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<128,125>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u}));
	// \src: top.v:11058.20-11058.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:11058$3237
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2095__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1579__o, p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<135>().val());
	// \src: top.v:2851.20-2851.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2851$999
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6086__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<7,3>().val(), value<4>{0xeu});
	// \src: top.v:2695.20-2695.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2695$943
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5862__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<7,3>().val(), value<5>{0x11u});
	// \src: top.v:2693.20-2693.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2693$942
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5858__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<7,3>().val(), value<5>{0x10u});
	// \src: top.v:2746.20-2746.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2746$964
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5921__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<6,3>().val(), value<4>{0xcu});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2742$962 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2738$960 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2736$959 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2734$958 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2730$956 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2726$954
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5912__o = or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<6,3>().val(), value<3>{0x4u}), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5902__o), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5905__o), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<6,3>().val(), value<3>{0x7u})), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5911__o);
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2722$952 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2718$950 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2714$948
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5891__o = or_uu<1>(or_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<6,3>().val()), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5887__o), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5890__o);
	// \src: top.v:2758.20-2758.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2758$970
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5948__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<6,3>().val(), value<4>{0xfu});
	// \src: top.v:2754.20-2754.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2754$968
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5939__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<6,3>().val(), value<4>{0xeu});
	// \src: top.v:2750.20-2750.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2750$966
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5930__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<6,3>().val(), value<4>{0xdu});
	// memory \unity_link_inst.core_inst.frame_writer_inst.n6751 read port 0
	auto tmp_0 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<133,128>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_0.valid && "out of bounds read");
	if(tmp_0.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6752__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6751[tmp_0.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6752__data = value<4> {};
	}
	// \full_case: 1
	// \src: top.v:3323.19-3323.19|top.v:3323.5-3328.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4688_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4688__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6320__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5746__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5723__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:3324.36-3324.36|top.v:3323.5-3328.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4687_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4687__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6320__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5746__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5723__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:3325.33-3325.33|top.v:3323.5-3328.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4686_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4686__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6320__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5746__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5723__o).val(), value<1>{0x1u});
	// memory \unity_link_inst.core_inst.frame_writer_inst.n6749 read port 0
	auto tmp_1 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<133,128>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_1.valid && "out of bounds read");
	if(tmp_1.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6750__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6749[tmp_1.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6750__data = value<4> {};
	}
	// memory \unity_link_inst.core_inst.frame_writer_inst.n6747 read port 0
	auto tmp_2 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<133,128>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_2.valid && "out of bounds read");
	if(tmp_2.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6748__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6747[tmp_2.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6748__data = value<4> {};
	}
	// memory \unity_link_inst.core_inst.frame_writer_inst.n6745 read port 0
	auto tmp_3 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<133,128>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_3.valid && "out of bounds read");
	if(tmp_3.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6746__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6745[tmp_3.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6746__data = value<4> {};
	}
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2519$897 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2517$896 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2515$895 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2511$894
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5675__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5653__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available.curr), not_u<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<134>().val(), p_unity__link__inst_2e_core__inst_2e_answer__valid)));
	// \src: top.v:3021.20-3021.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:3021$1061
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6292__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<2,0>().val(), value<2>{0x2u});
	// \src: top.v:2902.20-2902.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2902$1019
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6130__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<2,0>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5560$2006 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5556$2005 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5554$2004 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5552$2003
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4763__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample, (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr) ? value<1>{0x1u} : value<1>{0u})), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5476__q.curr.slice<3>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5550$2002 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5548$2001 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5546$2000
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4750__o = and_uu<1>(and_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4741__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4689__o), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room.curr);
	// \src: top.v:6769.20-6769.40
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6769$2460
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3910__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3909__o, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr);
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7990$2590 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7988$2589 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7980$2586 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7978$2585
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word = and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<78,71>().val(), value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u}), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2667__o));
	// \src: top.v:5851.20-5851.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5851$2121
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3975__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_access__failure.curr);
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7974$2584 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7972$2583
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2642__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2630__o) ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:7950.20-7950.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7950$2576
	p_unity__link__inst_2e_core__inst_2e_access__write = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<22>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<89>().val());
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6777$2464 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6775$2463
	p_unity__link__inst_2e_core__inst_2e_access__done = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3909__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2619$927 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2617$926 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2615$925 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2613$924 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2607$922 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2597$919 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2595$918 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2593$917 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2587$915 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2581$913 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2571$910 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2569$909 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2563$907 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:2567$908
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance, or_uu<1>(or_uu<1>((and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<63,55>().val(), value<1>{0x1u}), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5707__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5704__o)) ? value<1>{0x1u} : value<1>{0u}), (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5733__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5729__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5707__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5723__o))) ? value<1>{0x1u} : value<1>{0u})), (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5733__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5707__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5746__o)) ? value<1>{0x1u} : value<1>{0u})));
	// \src: top.v:1226.20-1226.39
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1226$494
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7073__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<51>().val(), p_unity__link__inst_2e_core__inst_2e_sent__ready.curr);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5206$1875 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5200$1872 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5198$1871 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:373$114 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:371$113 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:369$112 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5196$1870 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5194$1869
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4299__o = and_uu<1>(and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5482__q.curr, not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4284__o)), not_u<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr, (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr) ? value<1>{0x1u} : value<1>{0u})))), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4283__o);
	// \src: top.v:5845.20-5845.40
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5845$2118
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5102__o = add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5490__q.curr, value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:5787.19-5787.19|top.v:5787.5-5791.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4535_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4535__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5048__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4917__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:5788.32-5788.32|top.v:5787.5-5791.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4534_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4534__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5048__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4917__o).val(), value<1>{0x1u});
	// \src: top.v:5610.20-5610.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5610$2020
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4838__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5472__q.curr, value<4>{0x8u});
	// \src: top.v:5464.20-5464.66
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$mod$top.v:5464$1966
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4617__o = mod_uu<32>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<5>{0x14u});
	// \src: top.v:13112.19-13112.40
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:13112$3631
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n261__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr, p_unity__link__inst_2e_core__inst_2e_fifo__out__ready);
	// \src: top.v:13126.19-13126.40
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$eq$top.v:13126$3638
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n291__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12774$3575 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12766$3573 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12748$3569 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12746$3568 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12744$3567 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12728$3564 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12714$3560 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12674$3548 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12668$3547 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12654$3543 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12614$3531 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12608$3530 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12594$3526 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12554$3514 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12548$3513 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12534$3509 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12494$3497 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12488$3496 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12474$3492 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12434$3480 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12428$3479 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12414$3475 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12374$3463 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12368$3462 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12354$3458 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12314$3446 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12308$3445 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12294$3441 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3751 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3752_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3753_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12264$3431 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:12262$3430 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12278$3436 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12276$3435 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ge$top.v:12270$3433 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:12274$3434 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12306$3444 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12304$3443 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$add$top.v:12300$3442 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3747 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3748_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3749_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12324$3448 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:12322$3447 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12338$3453 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12336$3452 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ge$top.v:12330$3450 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:12334$3451 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12366$3461 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12364$3460 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$add$top.v:12360$3459 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3743 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3744_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3745_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12384$3465 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:12382$3464 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12398$3470 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12396$3469 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ge$top.v:12390$3467 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:12394$3468 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12426$3478 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12424$3477 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$add$top.v:12420$3476 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3739 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3740_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3741_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12444$3482 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:12442$3481 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12458$3487 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12456$3486 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ge$top.v:12450$3484 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:12454$3485 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12486$3495 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12484$3494 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$add$top.v:12480$3493 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3735 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3736_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3737_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12504$3499 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:12502$3498 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12518$3504 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12516$3503 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ge$top.v:12510$3501 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:12514$3502 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12546$3512 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12544$3511 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$add$top.v:12540$3510 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3731 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3732_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3733_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12564$3516 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:12562$3515 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12578$3521 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12576$3520 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ge$top.v:12570$3518 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:12574$3519 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12606$3529 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12604$3528 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$add$top.v:12600$3527 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3727 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3728_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3729_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12624$3533 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:12622$3532 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12638$3538 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12636$3537 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ge$top.v:12630$3535 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:12634$3536 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12666$3546 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12664$3545 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$add$top.v:12660$3544 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3723 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3724_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3725_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12684$3550 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:12682$3549 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12698$3555 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12696$3554 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ge$top.v:12690$3552 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:12694$3553 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12726$3563 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12724$3562 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$add$top.v:12720$3561
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1176__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n578__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<140,135>().concat(value<2>{0u}).val() : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n563__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<140,135>().concat(value<2>{0u}).val() : value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1139__o ? value<4>{0x9u} : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<117>().val() ? value<4>{0x7u} : value<3>{0u}.concat((and_uu<1>(eq_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<6>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<3,0>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<3,0>().val()), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<103,100>().val()), and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1107__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1087__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<3,0>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1107__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1087__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<3,0>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<3,0>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<64>().val(), and_uu<1>(eq_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<14>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<11,8>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<11,8>().val()), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<99,96>().val()), and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1042__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1022__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<11,8>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1042__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1022__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<11,8>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<11,8>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<65>().val(), and_uu<1>(eq_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<22>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<19,16>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<19,16>().val()), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<95,92>().val()), and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n977__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n957__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<19,16>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n977__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n957__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<19,16>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<19,16>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<66>().val(), and_uu<1>(eq_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<30>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<27,24>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<27,24>().val()), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<91,88>().val()), and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n912__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n892__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<27,24>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n912__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n892__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<27,24>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<27,24>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<67>().val(), and_uu<1>(eq_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<38>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<35,32>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<35,32>().val()), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<87,84>().val()), and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n847__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n827__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<35,32>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n847__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n827__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<35,32>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<35,32>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<68>().val(), and_uu<1>(eq_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<46>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<43,40>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<43,40>().val()), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<83,80>().val()), and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n782__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n762__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<43,40>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n782__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n762__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<43,40>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<43,40>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<69>().val(), and_uu<1>(eq_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<54>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<51,48>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<51,48>().val()), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<79,76>().val()), and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n717__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n697__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<51,48>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n717__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n697__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<51,48>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<51,48>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<70>().val(), and_uu<1>(eq_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<62>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<59,56>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<59,56>().val()), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<75,72>().val()), and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n651__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n631__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<59,56>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n651__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n631__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<59,56>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<59,56>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<71>().val()))))))))))))))))))))))) ? value<1>{0u} : value<1>{0x1u})).val()))).concat(value<3>{0x3u}).val()));
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:12230$3423 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12226$3421
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n564__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<7,0>().val(), value<4>{0xau}), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n563__o);
	// \src: top.v:12901.20-12901.47
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12901$3600
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1285__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1184__o ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<132,125>()).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1273__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<7,0>()).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12770$3574 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12755$3570 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12758$3571 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12762$3572
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1173__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n578__o ? value<61>{0u,0x8100500u} : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n563__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<124,121>().val() : value<4>{0x4u}).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n563__o ? value<1>{0x1u} : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n563__o ? value<1>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1139__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<117,64>()).val() : value<56>{0u,0x100500u})).val());
	// \src: top.v:12897.20-12897.47
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12897$3599
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1282__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1184__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<103,0>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1272__o.concat(value<1>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<71,65>()).concat(p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<7,0>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<63,8>()).val());
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$5082
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_2_3a_0_5d_) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6881__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6881__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6881__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6881__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6881__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6881__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6881__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$5098
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_2_3a_0_5d_) = not_u<14>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6973__o_5b_26_3a_0_5d_.slice<25>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6973__o_5b_26_3a_0_5d_.slice<22,21>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6973__o_5b_26_3a_0_5d_.slice<15>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6973__o_5b_26_3a_0_5d_.slice<11,9>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6973__o_5b_26_3a_0_5d_.slice<7,6>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6973__o_5b_26_3a_0_5d_.slice<4,3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6973__o_5b_26_3a_0_5d_.slice<1,0>()).concat(value<1>{0u}).val());
	// \src: top.v:1691.20-1691.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1691$582
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6905__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<2,0>().val());
	// \src: top.v:1836.20-1836.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1836$615
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7037__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<2,0>().val(), value<3>{0x4u});
	// \src: top.v:1832.20-1832.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1832$614
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7028__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<2,0>().val(), value<2>{0x3u});
	// \src: top.v:1830.20-1830.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1830$613
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7023__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<2,0>().val(), value<2>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8124$2634 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8122$2633 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8120$2632 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8116$2630
	p_unity__link__inst_2e_core__inst_2e_answer__has__id = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<24>().val(), (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2811__o, eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<23,20>().val(), value<4>{0xfu})) ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2841$996 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4714 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4715_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4707_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4708_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4709_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4710_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4711_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4712_CMP0
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6072__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<7>().val() ? value<5>{0u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6059__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6050__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6041__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6032__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5911__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6014__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6002__o).val(), value<1>{0x1u}) ? value<5>{0xdu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6059__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6050__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6041__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6032__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5911__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6014__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6002__o).val(), value<2>{0x2u}) ? value<5>{0x11u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6059__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6050__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6041__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6032__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5911__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6014__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6002__o).val(), value<3>{0x4u}) ? value<5>{0xbu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6059__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6050__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6041__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6032__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5911__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6014__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6002__o).val(), value<4>{0x8u}) ? value<5>{0x13u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6059__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6050__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6041__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6032__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5911__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6014__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6002__o).val(), value<5>{0x10u}) ? value<5>{0xeu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6059__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6050__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6041__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6032__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5911__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6014__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6002__o).val(), value<6>{0x20u}) ? value<5>{0x18u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6059__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6050__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6041__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6032__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5911__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6014__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6002__o).val(), value<7>{0x40u}) ? value<5>{0x10u} : value<5>{0u}))))))));
	// \src: top.v:2847.20-2847.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2847$998
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6081__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<7,3>().val(), value<5>{0x12u});
	// \full_case: 1
	// \src: top.v:3325.33-3325.33|top.v:3323.5-3328.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4685
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6623__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4686__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<42,39>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4687__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<54,51>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4688__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6752__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<127,124>().val())));
	// \full_case: 1
	// \src: top.v:3225.33-3225.33|top.v:3223.5-3228.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4690
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6519__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4686__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<42,39>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4687__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<54,51>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4688__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6750__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<127,124>().val())));
	// \full_case: 1
	// \src: top.v:3139.33-3139.33|top.v:3137.5-3142.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4695
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6426__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4686__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<42,39>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4687__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<54,51>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4688__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6748__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<127,124>().val())));
	// \full_case: 1
	// \src: top.v:3043.33-3043.33|top.v:3041.5-3046.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4700
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6323__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4686__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<42,39>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4687__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<54,51>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4688__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6746__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<127,124>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2501$890 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2499$889 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2497$888 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2493$887
	p_unity__link__inst_2e_core__inst_2e_answer__taken = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5653__o, p_unity__link__inst_2e_core__inst_2e_answer__valid), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<134>().val(), not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available.curr)));
	// \src: top.v:2653.20-2653.51
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2653$932
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5824__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5675__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6744__q.curr.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6744__q.curr.slice<47,39>()).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<127,55>().val());
	// \full_case: 1
	// \src: top.v:3571.19-3571.19|top.v:3571.5-3580.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4557_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4557__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6320__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5704__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5746__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5723__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6292__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6130__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5645__o).val(), value<7>{0x40u});
	// \full_case: 1
	// \src: top.v:3572.37-3572.37|top.v:3571.5-3580.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4556_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4556__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6320__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5704__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5746__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5723__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6292__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6130__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5645__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:3573.37-3573.37|top.v:3571.5-3580.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4555_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4555__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6320__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5704__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5746__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5723__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6292__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6130__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5645__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:3574.37-3574.37|top.v:3571.5-3580.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4554_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4554__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6320__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5704__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5746__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5723__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6292__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6130__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5645__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:3575.37-3575.37|top.v:3571.5-3580.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4553_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4553__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6320__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5704__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5746__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5723__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6292__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6130__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5645__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:3576.37-3576.37|top.v:3571.5-3580.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4552_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4552__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6320__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5704__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5746__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5723__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6292__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6130__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5645__o).val(), value<2>{0x2u});
	// \src: top.v:5514.20-5514.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5514$1985
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4700__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3910__o, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5532$1993 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5530$1992 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5528$1991 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5526$1990 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5522$1988 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5520$1987 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5516$1986
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted = and_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<8>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5476__q.curr.slice<4>().val())), (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4707__o ? value<1>{0x1u} : value<1>{0u})), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr));
	// \src: top.v:5592.20-5592.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5592$2011
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4805__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5472__q.curr, value<3>{0x7u});
	// \src: top.v:13330.19-13330.28
	// cell $flatten\unity_link_inst.\wishbone_master_inst.$or$top.v:13330$3698
	p_unity__link__inst_2e_wishbone__master__inst_2e_n221__o = or_uu<1>(p_wb__ack, p_wb__err);
	// \src: top.v:5538.20-5538.39
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5538$1996
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4730__o = add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr, value<1>{0x1u});
	// \src: top.v:1228.20-1228.41
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1228$495
	p_unity__link__inst_2e_core__inst_2e_n198__o = and_uu<1>(p_out__valid.curr, p_out__ready);
	// \src: top.v:1272.20-1272.41
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$eq$top.v:1272$517
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7104__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<1>{0x1u});
	// \src: top.v:5249.20-5249.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5249$1893
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4349__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<4>{0xbu});
	// \src: top.v:5208.20-5208.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5208$1876
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4299__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5484__q.curr);
	// \src: top.v:5239.20-5239.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5239$1889
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4339__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<4>{0xdu});
	// \src: top.v:5279.20-5279.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5279$1905
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4379__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<3>{0x5u});
	// \src: top.v:5234.20-5234.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5234$1887
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4334__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<4>{0xeu});
	// \src: top.v:5274.20-5274.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5274$1903
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4374__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<3>{0x6u});
	// \src: top.v:5305.20-5305.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5305$1915
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4404__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr);
	// \src: top.v:5229.20-5229.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5229$1885
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4329__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<4>{0xfu});
	// \src: top.v:5224.20-5224.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5224$1883
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4324__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<5>{0x10u});
	// \src: top.v:5219.20-5219.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5219$1881
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<5>{0x11u});
	// \src: top.v:5269.20-5269.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5269$1901
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4369__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<3>{0x7u});
	// \src: top.v:5299.20-5299.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5299$1913
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4399__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<1>{0x1u});
	// \src: top.v:5214.20-5214.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5214$1879
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4314__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<5>{0x12u});
	// \src: top.v:5210.20-5210.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5210$1877
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4308__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<5>{0x13u});
	// \src: top.v:5264.20-5264.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5264$1899
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4364__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<4>{0x8u});
	// \src: top.v:5294.20-5294.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5294$1911
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4394__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<2>{0x2u});
	// \src: top.v:5259.20-5259.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5259$1897
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4359__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<4>{0x9u});
	// \src: top.v:5289.20-5289.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5289$1909
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4389__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<2>{0x3u});
	// \src: top.v:5284.20-5284.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5284$1907
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4384__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<3>{0x4u});
	// \src: top.v:5244.20-5244.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5244$1891
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4344__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<4>{0xcu});
	// \src: top.v:5254.20-5254.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5254$1895
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4354__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, value<4>{0xau});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5978$2175 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5976$2174
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5257__o = (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5973$2173 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5970$2172
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5252__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5968$2171 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5965$2170
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5246__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<2>{0x2u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5963$2169 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5960$2168
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5240__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<2>{0x3u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5958$2167 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5955$2166
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5234__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<3>{0x4u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5953$2165 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5950$2164
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5228__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<3>{0x5u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5948$2163 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5945$2162
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5222__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<3>{0x6u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5943$2161 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5940$2160
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5216__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<3>{0x7u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5938$2159 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5935$2158
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5210__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<4>{0x8u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5933$2157 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5930$2156
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5204__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5928$2155 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5925$2154
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5198__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<4>{0xau}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5923$2153 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5920$2152
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5192__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<4>{0xbu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5918$2151 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5915$2150
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5186__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<4>{0xcu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5913$2149 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5910$2148
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5180__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<4>{0xdu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5908$2147 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5905$2146
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5174__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<4>{0xeu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5903$2145 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5900$2144
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5168__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<4>{0xfu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5898$2143 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5895$2142
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5162__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<5>{0x10u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5893$2141 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5890$2140
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5156__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<5>{0x11u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5888$2139 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5885$2138
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5150__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<5>{0x12u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5883$2137 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5881$2136
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5143__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, value<5>{0x13u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5316$1920 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5314$1919
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4299__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5484__q.curr));
	// \full_case: 1
	// \src: top.v:6553.32-6553.32|top.v:6550.5-6555.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4340_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4340__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4617__o.slice<1,0>().val(), value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:6552.32-6552.32|top.v:6550.5-6555.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4341_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4341__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4617__o.slice<1,0>().val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6551.32-6551.32|top.v:6550.5-6555.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4342_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4342__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4617__o.slice<1,0>().val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:6550.19-6550.19|top.v:6550.5-6555.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4343_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4343__CMP = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4617__o.slice<1,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:351$107 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:349$106 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ne$top.v:347$105 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:345$104 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:911$262 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4832 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4827 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4837 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4842 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4847 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4852
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counts = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7249__o_5b_4_3a_0_5d_.slice<4>().val() ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4803__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<19>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4804__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<18>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4805__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<17>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4806__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<16>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4798__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4803__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4804__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<14>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4805__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<13>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4806__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<12>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4799__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4803__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<11>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4804__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<10>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4805__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4806__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<8>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4800__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4803__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<7>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4804__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<6>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4805__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4806__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<4>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4801__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4803__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4804__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<2>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4805__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<1>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4806__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr.slice<0>().val() : value<1>{0u})))) : value<1>{0u})))))), (reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor.curr) ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:13152$3651 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$not$top.v:13150$3650
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n309__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n261__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n260__o));
	// \src: top.v:12068.19-12068.40
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:12068$3391
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n410__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<71,64>().val());
	// \full_case: 1
	// \src: top.v:1911.19-1911.19|top.v:1911.5-1918.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4740_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4740__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7037__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7028__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7023__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6764__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6905__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:1912.32-1912.32|top.v:1911.5-1918.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4739_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4739__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7037__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7028__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7023__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6764__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6905__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:1913.32-1913.32|top.v:1911.5-1918.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4738_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4738__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7037__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7028__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7023__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6764__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6905__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:1915.35-1915.35|top.v:1911.5-1918.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4736_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4736__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7037__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7028__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7023__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6764__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6905__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:1914.32-1914.32|top.v:1911.5-1918.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4737_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4737__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7037__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7028__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7023__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6764__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6905__o).val(), value<2>{0x2u});
	// \src: top.v:8006.20-8006.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8006$2597
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2695__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11458$3372 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11112$3252
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2478__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2095__o ? value<1>{0x1u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2116__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<172,165>().concat(value<1>{0x1u}).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<184,177>().concat(value<1>{0u}).val())).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<185,177>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11052$3235 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11036$3232 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11024$3229 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3771 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3772_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3773_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3774_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3775_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$sub$top.v:10881$3179 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3837 $auto$opt_reduce.cc:131:opt_pmux$5198 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11042$3233 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3834 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3831 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3827 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3822 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3816 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3809 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3801 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10744$3162 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11016$3227 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:11026$3230 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11011$3226 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11030$3231 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11020$3228
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2092__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<184,177>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<175,8>()).val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1859__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<172,165>().concat(value<1>{0x1u}).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<184,177>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<184,177>().concat(value<1>{0u}).val()).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1891__o.slice<10>()).concat((and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1859__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o) ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<173>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1891__o.slice<8,0>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2056__o)).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1891__o.slice<9,0>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3793__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<174>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<160,101>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1817__o).val() : value<60>{0u,0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1817__o).val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<164,101>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3810__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<96,85>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1817__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<100,85>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3817__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<80,77>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1817__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<84,77>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3823__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<72,69>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1817__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<76,69>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3828__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<64,61>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1817__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<68,61>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3832__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<56,29>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1817__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<60,29>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3835__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<24,17>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1817__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<28,17>().val())).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<184,177>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<175,17>()).val()).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3793__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3810__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3817__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3823__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3828__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3832__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3835__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<16>().val() : value<1>{0x1u}).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2037__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2034__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2031__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2025__o).val(), value<1>{0x1u}) ? value<4>{0x2u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2037__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2034__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2031__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2025__o).val(), value<2>{0x2u}) ? value<4>{0x7u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2037__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2034__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2031__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2025__o).val(), value<3>{0x4u}) ? value<4>{0xfu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2037__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2034__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2031__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2025__o).val(), value<4>{0x8u}) ? value<4>{0x3u} : value<4>{0x1u})))).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2014__o).val() : sub_uu<4>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left, value<1>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field).val())).val() : value<1>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field).val())).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$and$top.v:1100$478 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$not$top.v:1098$477 $flatten\unity_link_inst.\core_inst.$or$top.v:14085$3710 $flatten\unity_link_inst.\core_inst.$or$top.v:14083$3709 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$or$top.v:1559$555 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1557$554 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ne$top.v:1555$553 $flatten\unity_link_inst.\core_inst.$or$top.v:14081$3708 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2553$904 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2551$903 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:2549$902 $flatten\unity_link_inst.\core_inst.$or$top.v:14079$3707 $flatten\unity_link_inst.\core_inst.$or$top.v:14077$3706 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10508$3112 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10506$3111 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10504$3110 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:10502$3109 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:10498$3108 $flatten\unity_link_inst.\core_inst.$or$top.v:14075$3705 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:12062$3390 $flatten\unity_link_inst.\core_inst.$or$top.v:14073$3704
	p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n7182__o = and_uu<1>(not_u<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr, p_unity__link__inst_2e_core__inst_2e_character__valid.curr), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<119>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<133>().val())), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<186>().val(), (or_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<4,0>().val(), value<5>{0x10u}), reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<11,8>().val())) ? value<1>{0x1u} : value<1>{0u}))), p_unity__link__inst_2e_core__inst_2e_hold), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<144>().val(), (reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<2,0>().val()) ? value<1>{0x1u} : value<1>{0u}))), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<51>().val(), (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<2,0>().val(), value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u}))), p_out__valid.curr)), p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n7212__q.curr);
	// \src: top.v:2843.20-2843.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:2843$997
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6074__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6072__o);
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2891$1014 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2885$1011 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2879$1008
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6123__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6081__o ? value<6>{0x3u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6086__o ? value<6>{0x3fu} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<9>().val() ? value<2>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<46,43>()).val() : value<2>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6114__o_5b_3_3a_0_5d_).val())));
	// \src: top.v:3086.20-3086.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$sub$top.v:3086$1073
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6363__o = sub_uu<6>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<133,128>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2893$1015 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2887$1012 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2881$1009 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2869$1003
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6124__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6081__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6086__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<9>().val() ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6115__o ? value<1>{0x1u} : value<1>{0u}))));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:3291$1124 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:3284$1121
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6584__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<63,55>().val(), value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5707__o);
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2889$1013 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2883$1010 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2877$1007
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6122__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6081__o ? value<3>{0x5u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6086__o ? value<3>{0x6u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<9>().val() ? value<3>{0x3u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6113__o)));
	// \full_case: 1
	// \src: top.v:3577.37-3577.37|top.v:3571.5-3580.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4551_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4551__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6320__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5704__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5746__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5723__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6292__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6130__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5645__o).val(), value<1>{0x1u});
	// cell $auto$opt_reduce.cc:131:opt_pmux$5222
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5201 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4554__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4555__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4556__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4557__CMP).val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$5212
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5189 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4552__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4553__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5582$2008 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5580$2007
	p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write = or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4750__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4763__o), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4700__o);
	// \src: top.v:5594.20-5594.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5594$2012
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4812__o = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4805__o ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:5606.20-5606.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5606$2018
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4828__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5472__q.curr, value<4>{0x9u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8002$2596 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8000$2595
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__done, (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3975__o ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9164$2942 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9149$2936 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8770$2830 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4186 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9122$2927 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9113$2924 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4074 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4076_CMP0 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9126$2928 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9129$2929 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9133$2930 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8511$2755 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4246
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3540__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<18>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<193>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<17,16>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3132__o).concat(value<3>{0x7u}).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3112__o.concat(value<1>{0u}).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4093__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<28,17>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3132__o)).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3106__o).val()) : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<19>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<17,16>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3494__o.slice<14,13>().val()).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<19>().val() ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3494__o.slice<12>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<19>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<14,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3494__o.slice<11,0>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<19>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val() : value<3>{0x7u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4058__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3464__o.slice<2,0>().val() : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2114__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3484__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3475__o).val(), value<3>{0x4u}) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val() : value<3>{0x7u})))).val()) : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<193>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<17,3>().concat(value<3>{0x7u}).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3112__o.concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4093__CMP ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<28,17>()).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<15,3>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3106__o).val()));
	// \src: top.v:8266.20-8266.44
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:8266$2684
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2955__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<192,189>().val());
	// \src: top.v:9349.20-9349.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:9349$3001
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3692__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val(), value<3>{0x5u});
	// \src: top.v:9318.20-9318.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:9318$2992
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3662__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val(), value<2>{0x3u});
	// \src: top.v:9226.20-9226.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:9226$2963
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3587__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val(), value<2>{0x2u});
	// \src: top.v:9224.20-9224.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:9224$2962
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3583__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6763$2457 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6757$2454 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6755$2453 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6753$2452 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6751$2451
	p_unity__link__inst_2e_core__inst_2e_access__granted = and_uu<1>(and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<88>().val(), not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3871__o)), not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4059__q.curr)), p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3881__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8044$2612 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:8042$2611 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7996$2593 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7994$2592 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7992$2591
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2728__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__done, (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_access__failure.curr) ? value<1>{0x1u} : value<1>{0u})), not_u<1>(p_unity__link__inst_2e_core__inst_2e_access__write));
	// cells $flatten\unity_link_inst.\wishbone_master_inst.$or$top.v:13326$3696 $flatten\unity_link_inst.\wishbone_master_inst.$not$top.v:13324$3695
	p_unity__link__inst_2e_wishbone__master__inst_2e_n224__o = or_uu<1>(p_unity__link__inst_2e_wishbone__master__inst_2e_n238__q.curr, not_u<1>(p_wb__stall));
	// \src: top.v:6819.20-6819.48
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:6819$2485
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3954__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4063__q.curr);
	// \src: top.v:6839.20-6839.34
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:6839$2495
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3973__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4057__q.curr, value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8024$2603 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:8022$2602 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:8020$2601
	p_unity__link__inst_2e_core__inst_2e_access__more = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue));
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1268$515 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$not$top.v:1266$514
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7122__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_n198__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7073__o));
	// \src: top.v:5310.20-5310.28
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5310$1917
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4407__o = not_u<20>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr);
	// \src: top.v:5825.20-5825.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5825$2108
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5084__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5472__q.curr, value<3>{0x4u});
	// \src: top.v:5823.20-5823.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5823$2107
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5082__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5472__q.curr, value<2>{0x3u});
	// \src: top.v:5821.20-5821.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5821$2106
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5080__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5472__q.curr, value<2>{0x2u});
	// \src: top.v:5811.20-5811.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5811$2101
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5069__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5472__q.curr, value<1>{0x1u});
	// \src: top.v:5618.20-5618.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5618$2024
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4850__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<92,90>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5616$2023 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5614$2022 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$or$top.v:335$102 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$or$top.v:333$101 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$or$top.v:331$100 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5612$2021
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out = and_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4838__o ? value<1>{0x1u} : value<1>{0u}), not_u<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7583__q.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7585__q.curr), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick.curr)));
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:357$110 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:355$109 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:353$108
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counts, (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter.curr, value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1684$579 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1679$578 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1675$577 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$add$top.v:1671$576 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1667$575
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6900__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<144>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6853__o_5b_26_3a_0_5d_.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6860__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6867__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6874__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6881__o_5b_26_3a_0_5d_.slice<26>()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6846__o_5b_26_3a_0_5d_.slice<26>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6881__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6881__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6881__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6881__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6881__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6881__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6887__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6881__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val())).concat(add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<6,3>().val(), value<1>{0x1u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<6,3>().val(), value<2>{0x2u}) ? value<3>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<2,0>().val())).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<38,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$and$top.v:1096$476 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$eq$top.v:1094$475
	p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n7180__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark.curr, value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left.curr);
	// cell $auto$opt_reduce.cc:131:opt_pmux$5196
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5125 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4552__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4553__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4554__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4555__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4556__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4557__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2673$936 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2623$928 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8142$2640 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8138$2638 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:8136$2637 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:8132$2636 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8222$2670 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8190$2660 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4258 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8182$2658 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8180$2657 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8178$2656 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8176$2655 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8174$2654 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8172$2653 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8170$2652 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8168$2651 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8166$2650 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8164$2649 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8162$2648 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8158$2646 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8154$2644 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8150$2642 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2631$929 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8214$2668 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8224$2671 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8128$2635
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5836__o = (p_unity__link__inst_2e_core__inst_2e_answer__taken ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2785__o ? value<4>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<105,102>()).val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<23>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<76,69>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<201,194>().val())).concat(value<1>{0u}).concat((p_unity__link__inst_2e_core__inst_2e_answer__has__id ? value<3>{0x2u}.concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<106>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<14,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<38,27>().val())).concat(value<20>{0u}).val() : value<3>{0x7u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<60,29>()).val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2785__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<24>().val() ? value<1>{0u} : (or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<23,20>().val(), value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2642__o), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2627__o), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2630__o), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<23,20>().val(), value<4>{0x8u})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<23,20>().val(), value<4>{0x9u})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<23,20>().val(), value<4>{0xau})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<23,20>().val(), value<4>{0xbu})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<23,20>().val(), value<4>{0xcu})) ? value<1>{0x1u} : value<1>{0u})))).concat(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_answer__has__id, and_uu<1>(and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<24>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<23>().val())), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2811__o))).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<54,9>().val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$5206
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5195 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4552__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4553__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4554__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4555__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4557__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2683$939 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2656$933
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5843__o = (p_unity__link__inst_2e_core__inst_2e_answer__taken ? value<2>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5675__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6744__q.curr.slice<38>().concat(value<1>{0x1u}).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<135,134>().val()));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2668$935 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8220$2669 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8212$2667 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2650$931
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5833__o = (p_unity__link__inst_2e_core__inst_2e_answer__taken ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<24>().concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2785__o ? value<5>{0x10u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<106>().val() ? value<5>{0x11u} : value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<23,20>()).val()))).concat(value<3>{0x1u}).val() : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5675__o ? value<9>{0x91u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<8,0>().val()));
	// \src: top.v:5608.20-5608.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5608$2019
	p_unity__link__inst_2e_core__inst_2e_group__done = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4828__o ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:9327.20-9327.44
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:9327$2995
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3672__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<86,79>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<201,194>().val());
	// \full_case: 1
	// \src: top.v:9549.19-9549.19|top.v:9549.5-9559.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3935_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3935__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2732__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2761__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3692__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2758__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3662__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3587__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3583__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2695__o).val(), value<8>{0x80u});
	// \full_case: 1
	// \src: top.v:9550.38-9550.38|top.v:9549.5-9559.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3934_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3934__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2732__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2761__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3692__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2758__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3662__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3587__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3583__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2695__o).val(), value<7>{0x40u});
	// \full_case: 1
	// \src: top.v:9551.38-9551.38|top.v:9549.5-9559.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3933_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3933__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2732__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2761__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3692__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2758__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3662__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3587__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3583__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2695__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:9552.38-9552.38|top.v:9549.5-9559.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3932_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3932__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2732__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2761__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3692__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2758__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3662__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3587__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3583__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2695__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:9553.38-9553.38|top.v:9549.5-9559.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3931_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3931__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2732__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2761__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3692__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2758__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3662__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3587__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3583__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2695__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:9554.38-9554.38|top.v:9549.5-9559.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3930_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3930__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2732__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2761__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3692__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2758__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3662__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3587__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3583__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2695__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:9555.38-9555.38|top.v:9549.5-9559.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3929_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3929__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2732__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2761__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3692__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2758__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3662__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3587__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3583__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2695__o).val(), value<2>{0x2u});
	// \src: top.v:9234.20-9234.41
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$add$top.v:9234$2965
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3592__o = add_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<86,79>().val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:9556.38-9556.38|top.v:9549.5-9559.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3928_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3928__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2732__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2761__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3692__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2758__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3662__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3587__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3583__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2695__o).val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\wishbone_master_inst.$and$top.v:13322$3694 $flatten\unity_link_inst.\wishbone_master_inst.$and$top.v:13316$3691
	p_unity__link__inst_2e_bus__done = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_bus__request.curr, p_unity__link__inst_2e_wishbone__master__inst_2e_n221__o), p_unity__link__inst_2e_wishbone__master__inst_2e_n224__o);
	// \src: top.v:6797.20-6797.40
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$or$top.v:6797$2474
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3936__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample, p_unity__link__inst_2e_core__inst_2e_access__granted);
	// \full_case: 1
	// \src: top.v:6955.19-6955.19|top.v:6955.5-6960.12
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$4273_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4273__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3902__o.concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3973__o).concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3874__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:6956.35-6956.35|top.v:6955.5-6960.12
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$4272_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4272__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3902__o.concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3973__o).concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3874__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6957.33-6957.33|top.v:6955.5-6960.12
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$4271_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4271__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3902__o.concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3973__o).concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3874__o).val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3941$1693 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2533$901 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2531$900 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$add$top.v:3939$1692
	p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5592__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5675__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<134>().val())) ? add_uu<13>(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5623__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5623__q.curr);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5312$1918 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5307$1916 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5302$1914 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5297$1912 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5292$1910 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5287$1908 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5282$1906 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5277$1904 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5272$1902 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5267$1900 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5262$1898 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5257$1896 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5252$1894 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5247$1892 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5242$1890 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5237$1888 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5232$1886 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5227$1884 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5222$1882 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5217$1880 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5212$1878
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer = or_uu<20>((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4308__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u}).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4314__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4324__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4329__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4334__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4339__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4344__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4349__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4354__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4359__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4364__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4369__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4374__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4379__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4384__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4389__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4394__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4399__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4404__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4301__o : value<1>{0u})).val(), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4407__o);
	// \full_case: 1
	// \src: top.v:6259.40-6259.40|top.v:6251.5-6263.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4403_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4403__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4828__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4838__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4805__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4692__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4741__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5084__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5082__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5080__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5069__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4276__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6258.40-6258.40|top.v:6251.5-6263.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4404_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4404__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4828__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4838__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4805__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4692__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4741__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5084__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5082__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5080__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5069__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4276__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:6257.40-6257.40|top.v:6251.5-6263.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4405_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4405__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4828__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4838__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4805__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4692__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4741__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5084__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5082__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5080__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5069__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4276__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:6256.41-6256.41|top.v:6251.5-6263.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4406_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4406__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4828__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4838__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4805__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4692__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4741__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5084__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5082__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5080__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5069__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4276__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:6255.41-6255.41|top.v:6251.5-6263.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4407_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4407__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4828__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4838__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4805__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4692__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4741__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5084__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5082__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5080__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5069__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4276__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:6254.40-6254.40|top.v:6251.5-6263.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4408_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4408__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4828__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4838__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4805__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4692__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4741__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5084__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5082__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5080__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5069__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4276__o).val(), value<7>{0x40u});
	// \full_case: 1
	// \src: top.v:6253.40-6253.40|top.v:6251.5-6263.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4409_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4409__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4828__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4838__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4805__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4692__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4741__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5084__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5082__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5080__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5069__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4276__o).val(), value<8>{0x80u});
	// \full_case: 1
	// \src: top.v:6252.40-6252.40|top.v:6251.5-6263.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4410_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4410__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4828__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4838__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4805__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4692__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4741__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5084__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5082__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5080__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5069__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4276__o).val(), value<9>{0x100u});
	// \full_case: 1
	// \src: top.v:6251.19-6251.19|top.v:6251.5-6263.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4411_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4411__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4828__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4838__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4805__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4692__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4741__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5084__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5082__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5080__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5069__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4276__o).val(), value<10>{0x200u});
	// \full_case: 1
	// \src: top.v:6260.40-6260.40|top.v:6251.5-6263.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4402_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4402__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4828__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4838__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4805__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4692__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4741__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5084__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5082__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5080__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5069__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4276__o).val(), value<1>{0x1u});
	// \src: top.v:5448.20-5448.25
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5448$1964
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4589__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<9>().val());
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:13142$3646 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$not$top.v:13140$3645
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n301__o = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n261__o), p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n260__o);
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:13132$3641 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$or$top.v:13130$3640 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:13128$3639 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$eq$top.v:13124$3637
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o = and_uu<1>(or_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n261__o, p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n291__o)), p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n260__o);
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1258$510 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$not$top.v:1256$509
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7114__o = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_n198__o), p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7073__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:11489$3380 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8008$2598
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2500__o = and_uu<1>((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2695__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<186>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11485$3379 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10430$3096 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10424$3093 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11467$3374 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11047$3234 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10666$3147 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3852 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3899 $auto$opt_reduce.cc:131:opt_pmux$5214 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3886 $auto$opt_reduce.cc:131:opt_pmux$5210 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3876 $auto$opt_reduce.cc:131:opt_pmux$5208 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3864 $auto$opt_reduce.cc:131:opt_pmux$5204 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3846 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3890 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3882 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3870 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3858 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10674$3148 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10682$3150 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10680$3149 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11470$3375 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11108$3251 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:11454$3371 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11103$3250 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11473$3376 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11477$3377 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11481$3378 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11461$3373 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11450$3370 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:11295$3316 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11448$3369 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:11327$3326 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:11309$3320 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:11299$3317 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:11307$3319 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:11305$3318 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:11325$3325 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:11323$3324 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:11321$3323 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:11315$3321 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11446$3368 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11442$3366 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3755 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3756_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3757_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3758_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11409$3357 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11405$3355 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11401$3353 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11397$3351 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11389$3347 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11403$3354 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11399$3352 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:11369$3340 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11391$3348 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:11387$3346 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:11425$3361 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:11415$3359 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:11423$3360 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11259$3304 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3764 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3765_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3766_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3767_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3768_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3769_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:11134$3259 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:11157$3267 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:11150$3266 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:11146$3264 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:11148$3265 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:11214$3288 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:11207$3287 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:11201$3285 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:11195$3283 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:11193$3282 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:11189$3281 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:11187$3280 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:11238$3298 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3760 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3761_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3762_CMP0
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2498__o = (and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<133>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1567__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1570__o) ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<134>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2095__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<201,186>().val() : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2320__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2314__o).val(), value<1>{0x1u}) ? value<8>{0x1u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2320__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2314__o).val(), value<2>{0x2u}) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<172,165>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<68,61>().val())).concat(((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1467__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2270__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1969__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2217__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o).val(), value<1>{0x1u}) ? or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2173__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2176__o) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1467__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2270__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1969__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2217__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o).val(), value<2>{0x2u}) ? or_uu<1>(and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<3,0>().val(), value<2>{0x3u}), gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<173,165>().val(), value<8>{0xffu})), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<175>().val()) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1467__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2270__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1969__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2217__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o).val(), value<3>{0x4u}) ? or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2220__o, reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<84,83>().concat(value<6>{0u}).val())), logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<100,85>().val())), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2173__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2176__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<175>().val()) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1467__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2270__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1969__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2217__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o).val(), value<4>{0x8u}) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2220__o : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1467__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2270__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1969__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2217__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o).val(), value<5>{0x10u}) ? gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<76,69>().val(), value<2>{0x2u}) : value<1>{0u}))))) ? value<1>{0x1u} : value<1>{0u})).concat((reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<139,136>().val()) ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<139,136>().val() : (and_uu<1>(not_u<1>(and_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<3,0>().val(), value<4>{0xeu}), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1444__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<5>().val())), and_uu<1>(not_u<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<6>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<7>().val())), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<4>().val()))) ? value<2>{0u}.concat(((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<16>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2367__o : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1858__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1856__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2375__o).val(), value<1>{0x1u}) ? value<1>{0x1u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1858__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1856__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2375__o).val(), value<2>{0x2u}) ? ((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<16>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2361__o : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2386__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2216__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2419__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2361__o)))) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2386__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2216__o ? eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<173,165>().val(), value<2>{0x2u}) : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2419__o ? eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<173,165>().val(), value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2367__o)))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1858__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1856__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2375__o).val(), value<3>{0x4u}) ? and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<173,165>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<68,61>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<174>().val())) : value<1>{0u})))) ? value<2>{0u} : value<2>{0x3u})).val() : value<4>{0x2u}))).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<140>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<135>()).concat(value<1>{0x1u}).val()).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2478__o.slice<9>()).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<201,185>().val()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<134>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2478__o.slice<8,0>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2092__o.slice<176,168>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<134>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<175>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2092__o.slice<167>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<134>().val() ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2116__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2095__o) ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<173>().val() ? value<1>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<172,165>()).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2056__o)).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<174,165>().val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2092__o.slice<166,157>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<134>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<164,0>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2092__o.slice<156,0>().concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter ? or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<7>().val(), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<130>().val())).concat(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<6>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<130>().val())).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<130>()).concat(((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3847__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3891__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3892__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3893__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3894__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3895__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3896__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3897__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3848__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3883__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3884__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3849__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3871__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3872__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3873__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3874__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3850__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3859__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3860__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3861__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3862__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : value<1>{0x1u})))) ? value<5>{0x1fu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3847__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3891__CMP ? value<5>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3892__CMP ? value<5>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3893__CMP ? value<5>{0xdu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3894__CMP ? value<5>{0xeu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3895__CMP ? value<5>{0xfu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3896__CMP ? value<5>{0xcu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3897__CMP ? value<5>{0x11u} : value<5>{0u}))))))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3848__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3883__CMP ? value<5>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3884__CMP ? value<5>{0x2u} : value<5>{0u})) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3849__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3871__CMP ? value<5>{0x5u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3872__CMP ? value<5>{0x7u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3873__CMP ? value<5>{0x6u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3874__CMP ? value<5>{0x3u} : value<5>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3850__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3859__CMP ? value<5>{0x8u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3860__CMP ? value<5>{0x9u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3861__CMP ? value<5>{0xau} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3862__CMP ? value<5>{0xbu} : value<5>{0u})))) : value<5>{0u})))))).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<7,0>().val())).val())).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<201,177>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<175,0>()).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$and$top.v:1092$474 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$eq$top.v:1090$473
	p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n7177__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark.curr, value<2>{0x2u}), p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left.curr);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3935$1690 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5604$2017 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5602$2016 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3933$1689 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$add$top.v:3931$1688
	p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5588__o = (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4812__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted)) ? p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.curr : (p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write ? add_uu<13>(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5621__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5621__q.curr));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9204$2955 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9180$2948 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9184$2949
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3567__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<186>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2955__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<17,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3540__o.slice<17,3>().val()).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2955__o ? value<3>{0x7u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3540__o.slice<2,0>().val())).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<17,0>().val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$5182
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5163 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3929__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3930__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3931__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3932__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3933__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3934__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3935__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9207$2956 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9186$2950 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9166$2943
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3569__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<186>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<201,194>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<60,17>()).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<188,187>()).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2955__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<5>().val() ? value<1>{0x1u} : value<1>{0u}))).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<3,0>()).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<78,20>().val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$5176
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5165 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3929__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3930__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3932__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3933__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3934__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3935__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9314$2990 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9295$2984 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9280$2979 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9270$2976 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9299$2985 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9283$2980
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3658__o = (p_unity__link__inst_2e_core__inst_2e_access__done ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<89>().val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2667__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<89>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2667__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<88>().val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<88>().val())))).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<89,88>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9209$2957 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9189$2951 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9168$2944 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9153$2938 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9138$2932 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4064 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9192$2952 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9170$2945 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9155$2939 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9141$2933 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4061
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3570__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<186>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2955__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<92,90>().val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<18>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3127__o : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<19>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<92,90>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4058__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3127__o : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<92,90>().val()))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3127__o)).concat(value<1>{0u}).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2955__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<88>().val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<18>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3125__o : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<19>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<88>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4058__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3125__o : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<88>().val()))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3125__o))).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<92,88>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9212$2958 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9195$2953 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9173$2946 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9158$2940 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9143$2934 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4057 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4059_CMP0 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9198$2954 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9176$2947 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9161$2941 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9145$2935 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9118$2926
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3572__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<186>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2955__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<18>().val() ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<19>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<15>().val() ? value<1>{0u} : value<1>{0x1u}) : value<1>{0u})) : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2955__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<192,189>().val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<18>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3128__o : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<19>().val() ? value<4>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_4058__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3128__o : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2114__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3484__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3475__o).val(), value<2>{0x2u}) ? value<4>{0x8u} : value<4>{0u})))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3128__o))).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<106,102>().val());
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:7083$2546 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8064$2619 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8062$2618 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:7081$2545 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$add$top.v:7079$2544
	p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3817__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2739__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<26>().val())) ? p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.curr : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2728__o ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3850__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3850__q.curr));
	// cell $auto$opt_reduce.cc:131:opt_pmux$5156
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5151 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4272__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4273__CMP).val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$5160
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5159 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4271__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4273__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1248$505 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$or$top.v:1246$504 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1244$503 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$eq$top.v:1240$501
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7107__o = and_uu<1>(or_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_n198__o, p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7104__o)), p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7073__o);
	// \src: top.v:1035.20-1035.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$eq$top.v:1035$466
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n7220__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n7234__q.curr);
	// cell $auto$opt_reduce.cc:131:opt_pmux$5140
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5139 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4403__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4404__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4405__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4406__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4407__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4408__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4409__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4410__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4411__CMP).val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$5128
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5123 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4403__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4404__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4405__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4406__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4407__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4409__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4410__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4411__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5622$2026 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5620$2025
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4858__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4850__o ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$or$top.v:375$115 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5628$2029 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5626$2028 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5624$2027
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7294__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counts, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out, (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<92,90>().val(), value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u})));
	// \src: top.v:5634.20-5634.39
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5634$2032
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4880__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4812__o);
	// memory \unity_link_inst.core_inst.rx_fifo_inst.memory read port 0
	auto tmp_4 = memory_index(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n349__q.curr, 0, 256);
	CXXRTL_ASSERT(tmp_4.valid && "out of bounds read");
	if(tmp_4.valid) {
		value<9> tmp_5 = memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory[tmp_4.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_13210_24_3676__DATA = tmp_5;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_13210_24_3676__DATA = value<9> {};
	}
	// \src: top.v:1230.20-1230.51
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1230$496
	p_unity__link__inst_2e_core__inst_2e_tx__entry = (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7169__q.curr ? p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.curr : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7170__data.curr);
	// memory \unity_link_inst.core_inst.tx_fifo_inst.memory read port 0
	auto tmp_6 = memory_index(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7162__q.curr, 0, 256);
	CXXRTL_ASSERT(tmp_6.valid && "out of bounds read");
	if(tmp_6.valid) {
		value<10> tmp_7 = memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory[tmp_6.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_1326_24_540__DATA = tmp_7;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_1326_24_540__DATA = value<10> {};
	}
	// \full_case: 1
	// \src: top.v:9586.9-9586.14|top.v:9586.5-9587.41
	// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procmux$3918
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_9587_24_3023__EN_5b_63_3a_0_5d__24_3029_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<176>().val() ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:13212.9-13212.13|top.v:13212.5-13213.35
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$3712
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_13213_24_3629__EN_5b_8_3a_0_5d__24_3680_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n260__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:3981.9-3981.14|top.v:3981.5-3982.37
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procmux$4541
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_3982_24_1687__EN_5b_63_3a_0_5d__24_1713_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:7129.9-7129.14|top.v:7129.5-7130.37
	// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procmux$4261
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_7130_24_2543__EN_5b_63_3a_0_5d__24_2569_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2728__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:6398.9-6398.23|top.v:6398.5-6399.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4392
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_6399_24_1749__EN_5b_13_3a_0_5d__24_2276_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4858__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:6398.9-6398.23|top.v:6398.5-6399.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4398
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_6399_24_1749__ADDR_5b_4_3a_0_5d__24_2274 = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4858__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr : value<5>{0u});
	// \full_case: 1
	// \src: top.v:759.9-759.22|top.v:759.5-760.44
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4867
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_counters_24_top_2e_v_3a_760_24_66__EN_5b_15_3a_0_5d__24_241_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7294__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:806.9-806.15|top.v:806.5-807.40
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4858
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_losses_24_top_2e_v_3a_807_24_99__EN_5b_7_3a_0_5d__24_252_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:1328.9-1328.13|top.v:1328.5-1329.35
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$4787
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_1329_24_493__EN_5b_9_3a_0_5d__24_544_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7073__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:6442.9-6442.20|top.v:6442.5-6443.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4383
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_state__memory_24_top_2e_v_3a_6443_24_1782__EN_5b_9_3a_0_5d__24_2285_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4880__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:6452.9-6452.19|top.v:6452.5-6453.37
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4374
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_list_24_top_2e_v_3a_6453_24_1783__EN_5b_31_3a_0_5d__24_2294_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<93>().val() ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:6462.9-6462.18|top.v:6462.5-6463.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4365
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_last_24_top_2e_v_3a_6463_24_1784__EN_5b_63_3a_0_5d__24_2303_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4700__o ? value<1>{0x1u} : value<1>{0u});
	// memory \unity_link_inst.core_inst.request_memory_inst.memory read port 0
	auto tmp_8 = memory_index(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<86,79>().val(), 0, 256);
	CXXRTL_ASSERT(tmp_8.valid && "out of bounds read");
	if(tmp_8.valid) {
		value<64> tmp_9 = memory_p_unity__link__inst_2e_core__inst_2e_request__memory__inst_2e_memory[tmp_8.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2579__data_5b_63_3a_0_5d_ = tmp_9;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2579__data_5b_63_3a_0_5d_ = value<64> {};
	}
	// memory \unity_link_inst.core_inst.response_ring_inst.memory read port 0
	auto tmp_10 = memory_index(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3852__q.curr.slice<7,0>().val(), 0, 256);
	CXXRTL_ASSERT(tmp_10.valid && "out of bounds read");
	if(tmp_10.valid) {
		value<64> tmp_11 = memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory[tmp_10.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3857__data_5b_63_3a_0_5d_ = tmp_11;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3857__data_5b_63_3a_0_5d_ = value<64> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_sample_ring_inst.memory read port 0
	auto tmp_12 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5623__q.curr.slice<11,0>().val(), 0, 4096);
	CXXRTL_ASSERT(tmp_12.valid && "out of bounds read");
	if(tmp_12.valid) {
		value<64> tmp_13 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_memory[tmp_12.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_5c_n5628__data_5b_63_3a_0_5d_ = tmp_13;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_5c_n5628__data_5b_63_3a_0_5d_ = value<64> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.losses read port 1
	auto tmp_14 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7584__q.curr, 0, 32);
	CXXRTL_ASSERT(tmp_14.valid && "out of bounds read");
	if(tmp_14.valid) {
		value<8> tmp_15 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses[tmp_14.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n7609__data_5b_7_3a_0_5d_ = tmp_15;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n7609__data_5b_7_3a_0_5d_ = value<8> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.losses read port 0
	auto tmp_16 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr, 0, 32);
	CXXRTL_ASSERT(tmp_16.valid && "out of bounds read");
	if(tmp_16.valid) {
		value<8> tmp_17 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses[tmp_16.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n7607__data_5b_7_3a_0_5d_ = tmp_17;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n7607__data_5b_7_3a_0_5d_ = value<8> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.counters read port 0
	auto tmp_18 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7584__q.curr, 0, 32);
	CXXRTL_ASSERT(tmp_18.valid && "out of bounds read");
	if(tmp_18.valid) {
		value<16> tmp_19 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters[tmp_18.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n7603__data_5b_15_3a_0_5d_ = tmp_19;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n7603__data_5b_15_3a_0_5d_ = value<16> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.divisors read port 0
	auto tmp_20 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7584__q.curr, 0, 32);
	CXXRTL_ASSERT(tmp_20.valid && "out of bounds read");
	if(tmp_20.valid) {
		value<16> tmp_21 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors[tmp_20.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n7599__data_5b_15_3a_0_5d_ = tmp_21;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n7599__data_5b_15_3a_0_5d_ = value<16> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.settings_memory read port 0
	auto tmp_22 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, 0, 32);
	CXXRTL_ASSERT(tmp_22.valid && "out of bounds read");
	if(tmp_22.valid) {
		value<14> tmp_23 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory[tmp_22.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n5502__data_5b_13_3a_0_5d_ = tmp_23;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n5502__data_5b_13_3a_0_5d_ = value<14> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.state_memory read port 0
	auto tmp_24 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr, 0, 32);
	CXXRTL_ASSERT(tmp_24.valid && "out of bounds read");
	if(tmp_24.valid) {
		value<10> tmp_25 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory[tmp_24.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n5506__data_5b_9_3a_0_5d_ = tmp_25;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n5506__data_5b_9_3a_0_5d_ = value<10> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.list read port 0
	auto tmp_26 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr).val(), 0, 8192);
	CXXRTL_ASSERT(tmp_26.valid && "out of bounds read");
	if(tmp_26.valid) {
		value<32> tmp_27 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_list[tmp_26.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n5509__data_5b_31_3a_0_5d_ = tmp_27;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n5509__data_5b_31_3a_0_5d_ = value<32> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.last read port 0
	auto tmp_28 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5490__q.curr).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<9>()).val(), 0, 16384);
	CXXRTL_ASSERT(tmp_28.valid && "out of bounds read");
	if(tmp_28.valid) {
		value<64> tmp_29 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last[tmp_28.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n5512__data_5b_63_3a_0_5d_ = tmp_29;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n5512__data_5b_63_3a_0_5d_ = value<64> {};
	}
	// memory \unity_link_inst.core_inst.request_memory_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:9586.9-9586.14|top.v:9586.5-9587.41
		// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procmux$3924
		auto tmp_30 = memory_index((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<176>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<184,177>().val() : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_30.valid && "out of bounds write");
		if (tmp_30.valid) {
			// \full_case: 1
			// \src: top.v:9586.9-9586.14|top.v:9586.5-9587.41
			// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procmux$3921
			memory_p_unity__link__inst_2e_core__inst_2e_request__memory__inst_2e_memory.update(tmp_30.index, (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<176>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<164,101>().val() : value<64>{0u,0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_9587_24_3023__EN_5b_63_3a_0_5d__24_3029_5b_0_5d_.repeat<64>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.rx_fifo_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:13212.9-13212.13|top.v:13212.5-13213.35
		// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$3718
		auto tmp_31 = memory_index((p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n260__o ? p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n348__q.curr : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_31.valid && "out of bounds write");
		if (tmp_31.valid) {
			// \full_case: 1
			// \src: top.v:13212.9-13212.13|top.v:13212.5-13213.35
			// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$3715
			memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory.update(tmp_31.index, (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n260__o ? p_in__lost.concat(p_in__data).val() : value<9>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_13213_24_3629__EN_5b_8_3a_0_5d__24_3680_5b_0_5d_.repeat<9>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_sample_ring_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:3981.9-3981.14|top.v:3981.5-3982.37
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procmux$4547
		auto tmp_32 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write ? p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5621__q.curr.slice<11,0>().val() : value<12>{0u}), 0, 4096);
		CXXRTL_ASSERT(tmp_32.valid && "out of bounds write");
		if (tmp_32.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procmux$4544 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5586$2009 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5590$2010
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_memory.update(tmp_32.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4750__o ? value<3>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5488__q.curr).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5496__q.curr).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5476__q.curr.slice<3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5476__q.curr.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5476__q.curr.slice<2>()).concat(value<36>{0u,0u}).val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4763__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5487__q.curr.concat(value<32>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4065__q.curr)) : value<64>{0u,0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_3982_24_1687__EN_5b_63_3a_0_5d__24_1713_5b_0_5d_.repeat<64>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.response_ring_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:7129.9-7129.14|top.v:7129.5-7130.37
		// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procmux$4267
		auto tmp_33 = memory_index((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2728__o ? p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3850__q.curr.slice<7,0>().val() : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_33.valid && "out of bounds write");
		if (tmp_33.valid) {
			// \full_case: 1
			// \src: top.v:7129.9-7129.14|top.v:7129.5-7130.37
			// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procmux$4264
			memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory.update(tmp_33.index, (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2728__o ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4065__q.curr : value<64>{0u,0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_7130_24_2543__EN_5b_63_3a_0_5d__24_2569_5b_0_5d_.repeat<64>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.divisors write port 0
	if (posedge_p_clk) {
		auto tmp_34 = memory_index(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_6399_24_1749__ADDR_5b_4_3a_0_5d__24_2274, 0, 32);
		CXXRTL_ASSERT(tmp_34.valid && "out of bounds write");
		if (tmp_34.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4879 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5436$1963
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors.update(tmp_34.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4858__o ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<77>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<100,85>().val() : value<16>{0u}) : value<16>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_6399_24_1749__EN_5b_13_3a_0_5d__24_2276_5b_0_5d_.repeat<16>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.counters write port 0
	if (posedge_p_clk) {
		// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4873 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:377$116
		auto tmp_35 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7294__o ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr) : value<5>{0u}), 0, 32);
		CXXRTL_ASSERT(tmp_35.valid && "out of bounds write");
		if (tmp_35.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4870 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:383$118 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:385$119 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$sub$top.v:387$120
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters.update(tmp_35.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7294__o ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor.curr : sub_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter.curr, value<1>{0x1u})) : value<16>{0x1u}) : value<16>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_counters_24_top_2e_v_3a_760_24_66__EN_5b_15_3a_0_5d__24_241_5b_0_5d_.repeat<16>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.losses write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:806.9-806.15|top.v:806.5-807.40
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4864
		auto tmp_36 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr : value<5>{0u}), 0, 32);
		CXXRTL_ASSERT(tmp_36.valid && "out of bounds write");
		if (tmp_36.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4861 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:391$122 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:1013$269 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4802 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4797 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4807 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4812 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4817 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4822 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$add$top.v:389$121
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses.update(tmp_36.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due ? ((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7249__o_5b_4_3a_0_5d_.slice<4>().val() ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4803__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<19>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4804__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<18>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4805__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<17>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4806__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<16>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4798__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4803__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4804__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<14>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4805__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<13>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4806__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<12>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4799__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4803__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<11>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4804__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<10>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4805__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4806__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<8>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4800__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4803__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<7>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4804__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<6>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4805__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4806__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<4>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4801__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4803__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4804__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<2>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4805__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<1>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4806__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<0>().val() : value<1>{0u})))) : value<1>{0u}))))) ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__losses.curr, value<1>{0x1u}) : value<8>{0u}) : value<8>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_losses_24_top_2e_v_3a_807_24_99__EN_5b_7_3a_0_5d__24_252_5b_0_5d_.repeat<8>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.tx_fifo_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:1328.9-1328.13|top.v:1328.5-1329.35
		// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$4793
		auto tmp_37 = memory_index((p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7073__o ? p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7161__q.curr : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_37.valid && "out of bounds write");
		if (tmp_37.valid) {
			// \full_case: 1
			// \src: top.v:1328.9-1328.13|top.v:1328.5-1329.35
			// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$4790
			memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory.update(tmp_37.index, (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7073__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<50,41>().val() : value<10>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_1329_24_493__EN_5b_9_3a_0_5d__24_544_5b_0_5d_.repeat<10>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.settings_memory write port 0
	if (posedge_p_clk) {
		auto tmp_38 = memory_index(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_6399_24_1749__ADDR_5b_4_3a_0_5d__24_2274, 0, 32);
		CXXRTL_ASSERT(tmp_38.valid && "out of bounds write");
		if (tmp_38.valid) {
			// \full_case: 1
			// \src: top.v:6398.9-6398.23|top.v:6398.5-6399.42
			// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4395
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory.update(tmp_38.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4858__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<201,194>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<82,77>()).val() : value<14>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_6399_24_1749__EN_5b_13_3a_0_5d__24_2276_5b_0_5d_.repeat<14>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.state_memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:6442.9-6442.20|top.v:6442.5-6443.41
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4389
		auto tmp_39 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4880__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr : value<5>{0u}), 0, 32);
		CXXRTL_ASSERT(tmp_39.valid && "out of bounds write");
		if (tmp_39.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4386 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5654$2042 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5648$2039 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5644$2037 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5646$2038 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5652$2041 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5656$2043 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5640$2035 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5642$2036 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5658$2044
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory.update(tmp_39.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4880__o ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4805__o) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4589__o : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<9>().val()).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4805__o ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<8>().val()) : value<1>{0x1u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4805__o ? (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr) ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5488__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5488__q.curr) : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4850__o ? value<8>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<7,0>().val()))).val() : value<10>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_state__memory_24_top_2e_v_3a_6443_24_1782__EN_5b_9_3a_0_5d__24_2285_5b_0_5d_.repeat<10>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.list write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:6452.9-6452.19|top.v:6452.5-6453.37
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4380
		auto tmp_40 = memory_index((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<93>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<101,94>()).val() : value<13>{0u}), 0, 8192);
		CXXRTL_ASSERT(tmp_40.valid && "out of bounds write");
		if (tmp_40.valid) {
			// \full_case: 1
			// \src: top.v:6452.9-6452.19|top.v:6452.5-6453.37
			// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4377
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_list.update(tmp_40.index, (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<93>().val() ? p_unity__link__inst_2e_core__inst_2e_memory__word.curr.slice<31,0>().val() : value<32>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_list_24_top_2e_v_3a_6453_24_1783__EN_5b_31_3a_0_5d__24_2294_5b_0_5d_.repeat<32>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.last write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:6462.9-6462.18|top.v:6462.5-6463.41
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4371
		auto tmp_41 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4700__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5490__q.curr).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4589__o).val() : value<14>{0u}), 0, 16384);
		CXXRTL_ASSERT(tmp_41.valid && "out of bounds write");
		if (tmp_41.valid) {
			// \full_case: 1
			// \src: top.v:6462.9-6462.18|top.v:6462.5-6463.41
			// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4368
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last.update(tmp_41.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4700__o ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4065__q.curr : value<64>{0u,0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_last_24_top_2e_v_3a_6463_24_1784__EN_5b_63_3a_0_5d__24_2303_5b_0_5d_.repeat<64>().val(), 0);
		}
	}
	// cells $flatten\unity_link_inst.\with_fifo_fifo_port_inst.$procdff$4885 $flatten\unity_link_inst.\with_fifo_fifo_port_inst.$and$top.v:13251$3685 $flatten\unity_link_inst.\with_fifo_fifo_port_inst.$not$top.v:13249$3684
	if (posedge_p_clk) {
		p_out__flush.next = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_flush.curr, not_u<1>(p_rst));
	}
	// cells $flatten\unity_link_inst.\wishbone_master_inst.$and$top.v:13312$3689 $flatten\unity_link_inst.\wishbone_master_inst.$not$top.v:13310$3688
	p_wb__stb = and_uu<1>(p_unity__link__inst_2e_bus__request.curr, not_u<1>(p_unity__link__inst_2e_wishbone__master__inst_2e_n238__q.curr));
	// cells $flatten\unity_link_inst.\wishbone_master_inst.$procdff$4884 $flatten\unity_link_inst.\wishbone_master_inst.$ternary$top.v:13336$3701 $flatten\unity_link_inst.\wishbone_master_inst.$and$top.v:13334$3700 $flatten\unity_link_inst.\wishbone_master_inst.$not$top.v:13332$3699 $flatten\unity_link_inst.\wishbone_master_inst.$and$top.v:13328$3697
	if (posedge_p_clk) {
		p_unity__link__inst_2e_wishbone__master__inst_2e_n238__q.next = (p_rst ? value<1>{0u} : and_uu<1>(and_uu<1>(p_unity__link__inst_2e_bus__request.curr, p_unity__link__inst_2e_wishbone__master__inst_2e_n224__o), not_u<1>(p_unity__link__inst_2e_wishbone__master__inst_2e_n221__o)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4896 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13172$3661 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13118$3634 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$add$top.v:13116$3633
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n348__q.next = (p_rst ? value<8>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n260__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n348__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n348__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4895 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13174$3662 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13122$3636 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$add$top.v:13120$3635
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n349__q.next = (p_rst ? value<8>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n261__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n349__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n349__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4894 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13176$3663 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13166$3658 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$add$top.v:13144$3647 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13160$3655 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$sub$top.v:13154$3652
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n301__o ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<1>{0x1u}) : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n309__o ? sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4893 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13178$3664 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13168$3659 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13158$3654 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:13162$3656
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n301__o ? value<1>{0x1u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n291__o, p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n309__o) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4892 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13180$3665 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13170$3660 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13148$3649 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$eq$top.v:13146$3648 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13164$3657
	if (posedge_p_clk) {
		p_in__ready.next = (p_rst ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n301__o ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<8>{0xffu}) ? value<1>{0u} : p_in__ready.curr) : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n309__o ? value<1>{0x1u} : p_in__ready.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4891 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13182$3666 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13136$3643
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o ? p_in__lost.concat(p_in__data).val() : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4890 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13184$3667 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13138$3644 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13134$3642
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n356__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n261__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n356__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4889 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$3720
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n357__data.next = (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n261__o ? i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_13210_24_3676__DATA : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n357__data.curr);
	}
	// cells $flatten\unity_link_inst.\wishbone_master_inst.$or$top.v:13308$3687 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6783$2467 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6781$2466 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$or$top.v:6779$2465
	p_wb__cyc = or_uu<1>(p_unity__link__inst_2e_bus__request.curr, and_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4059__q.curr, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4060__q.curr), not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4062__q.curr)));
	// cells $flatten\unity_link_inst.\core_inst.\rx_register_inst.$procdff$4898 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:13010$3626 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:13006$3624
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_character__valid.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_fifo__out__ready ? p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr : p_unity__link__inst_2e_core__inst_2e_character__valid.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_register_inst.$procdff$4897 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:13008$3625 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:13004$3623 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:13114$3632
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_character__in.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_fifo__out__ready ? (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n356__q.curr ? p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.curr : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n357__data.curr) : p_unity__link__inst_2e_core__inst_2e_character__in.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procdff$4899 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12964$3617 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12962$3616 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12960$3615 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12199$3414 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12203$3415 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12207$3416 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12211$3417 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12215$3418 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12220$3419 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12083$3394 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12081$3393 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12957$3614 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12929$3608 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12933$3609 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12924$3607 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12918$3605 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$sub$top.v:12912$3603 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12908$3602 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:12920$3606 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12786$3579 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12938$3610 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12942$3611 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12946$3612 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:12951$3613
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.next = (p_rst ? value<141>{0u,0u,0u,0x8100500u,0u} : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_advance ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<120>().val() ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n410__o ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<118>().val() ? value<4>{0x9u} : value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<117>().val() ? value<3>{0x7u} : value<3>{0u})).val())).concat(value<2>{0x3u}).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<140,135>().concat(value<1>{0u}).val()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n410__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1273__o)).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n410__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<132,125>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<7,0>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n410__o ? value<21>{0x81005u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<124,121>().concat(value<1>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<119,104>()).val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n410__o ? value<40>{0u,0u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1272__o.concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<71,65>()).val())).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<63,56>()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n410__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<55,0>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<63,8>().val())).val() : (p_unity__link__inst_2e_core__inst_2e_character__valid.curr ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n564__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1176__o.slice<7,1>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<140,135>().concat(value<1>{0u}).val()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n564__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1176__o.slice<0>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1285__o.slice<8>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n564__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<132,125>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1285__o.slice<7,0>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n564__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1173__o.slice<60,54>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<124,121>().concat(value<2>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1139__o).val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n564__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1173__o.slice<53,0>().val() : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1184__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<117,104>().val() : (and_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1184__o ? value<1>{0u} : value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1288__o) ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<117>().val()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1288__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<116,104>().val() : sub_uu<13>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<116,104>().val(), value<1>{0x1u}))).val()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1282__o.slice<103,64>()).val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n564__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<63,0>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1282__o.slice<63,0>().val())).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<140,135>().concat(value<2>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<132,121>()).concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr.slice<119,0>()).val())) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n1338__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procdff$4983 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1924$624 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1922$623 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4777 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1798$605 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$and$top.v:1793$603 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1795$604 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1828$612 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4770 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$sub$top.v:1820$610 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4763 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1785$600 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1781$599 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4756 $auto$opt_reduce.cc:131:opt_pmux$5192 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4749 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1687$580 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1789$601 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1812$609 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$gt$top.v:1804$607 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$add$top.v:1808$608 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4742 $auto$opt_reduce.cc:131:opt_pmux$5146 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4735 $auto$opt_reduce.cc:131:opt_pmux$5218 $auto$opt_reduce.cc:131:opt_pmux$5142 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1689$581
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.next = (p_rst ? value<52>{0x1u,0u} : (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_advance ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4736__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4737__CMP).val()) ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<144>().val() ? value<1>{0x1u} : value<1>{0u}) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4738__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4739__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4740__CMP).val()) ? value<1>{0x1u} : value<1>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4740__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<40,39>().val() : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4736__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4737__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4738__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4739__CMP).val()) ? value<2>{0u} : value<2>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4736__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<144>().val() ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6814__o_5b_6_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<48,41>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4737__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<144>().val() ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<143,136>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<48,41>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4738__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<38,35>().val(), value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<38,35>().val())).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<38,35>()).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4739__CMP ? value<8>{0xdu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4740__CMP ? value<8>{0xau} : value<8>{0u})))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4737__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<148,147>().val() : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4736__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4738__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4739__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4740__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<40,39>().val() : value<2>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4736__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6900__o.slice<38,7>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4737__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<144>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6945__o_5b_26_3a_0_5d_.slice<26>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6952__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6959__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6966__o_5b_26_3a_0_5d_.slice<26>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6973__o_5b_26_3a_0_5d_.slice<26>()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6938__o_5b_26_3a_0_5d_.slice<26>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_26_5d_.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6973__o_5b_26_3a_0_5d_.slice<24,23>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_23_3a_22_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6973__o_5b_26_3a_0_5d_.slice<20,16>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_16_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6973__o_5b_26_3a_0_5d_.slice<14,12>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_12_3a_10_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6973__o_5b_26_3a_0_5d_.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_8_3a_7_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6973__o_5b_26_3a_0_5d_.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_5_3a_4_5d_).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6973__o_5b_26_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6979__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6973__o_5b_26_3a_0_5d_.slice<25,0>().concat(value<1>{0u}).val())).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<38,7>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4738__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<34,7>().concat(value<4>{0u}).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4739__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<38,7>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4740__CMP ? value<32>{0u} : value<32>{0u})))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4736__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6900__o.slice<6,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4737__CMP ? value<4>{0x8u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4738__CMP ? sub_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<6,3>().val(), value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4739__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<6,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4740__CMP ? value<4>{0u} : value<4>{0u})))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4736__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6900__o.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4737__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<145>().val(), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<144>().val()) ? value<2>{0x1u}.concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<146>().val() ? value<1>{0x1u} : value<1>{0u})).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4738__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6810__o ? value<3>{0x4u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4739__CMP ? value<3>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4740__CMP ? value<3>{0x1u} : value<3>{0u})))))).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4994 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1288$525 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1234$498 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$add$top.v:1232$497
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7161__q.next = (p_rst ? value<8>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7073__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7161__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7161__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4993 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1290$526 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1238$500 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$add$top.v:1236$499
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7162__q.next = (p_rst ? value<8>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_n198__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7162__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7162__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4992 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1292$527 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1282$522 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$add$top.v:1260$511 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1276$519 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$sub$top.v:1270$516
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7114__o ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<1>{0x1u}) : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7122__o ? sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procdff$4900 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11507$3384 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11494$3381 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11497$3382 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11500$3383
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.next = (p_rst ? value<202>{0x10u,0u,0u,0u,0u,0u,0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2498__o.slice<201,187>().concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2500__o ? value<2>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2498__o.slice<186,185>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2498__o.slice<184,17>()).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2500__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2498__o.slice<16>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2498__o.slice<15,12>()).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2500__o ? value<12>{0x10u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2498__o.slice<11,0>().val())).val());
	}
	// \src: top.v:9582.3-9584.40
	// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procdff$4904
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_memory__word.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2579__data_5b_63_3a_0_5d_;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$procdff$4995 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1114$485 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1110$483 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1106$481 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1102$479
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_flush.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n7177__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n7180__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n7182__o ? value<1>{0x1u} : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$procdff$4996 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1120$488 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1112$484 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1108$482 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1104$480
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n7212__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n7177__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n7180__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n7182__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n7212__q.curr))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$procdff$4997 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1118$487
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark.next = (p_rst ? value<2>{0u} : p_unity__link__inst_2e_core__inst_2e_tx__entry.slice<9,8>().val());
	}
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procdff$4982 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3591$1164 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3589$1163 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4676 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2895$1016 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3111$1082 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3197$1102 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3287$1122 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3375$1143 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4667 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4658 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4649 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3067$1070 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4640 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4631 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3078$1072 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4622 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3294$1125 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$sub$top.v:3276$1119 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2677$937 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8206$2666 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8204$2665 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8198$2663 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:8196$2662 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8202$2664 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3586$1162 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3584$1161 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4613 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2681$938 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4604 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2898$1017 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3113$1083 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3199$1103 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3296$1126 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3280$1120 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4595 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4586 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3299$1127 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4577 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2774$973 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4731 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4732_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4733_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4723 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4724_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4725_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4726_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4727_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4728_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4729_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3056$1068 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:3048$1066 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:3052$1067 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3152$1092 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:3144$1090 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:3148$1091 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3238$1112 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:3230$1110 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:3234$1111 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3338$1136 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:3330$1134 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:3334$1135 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4568 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4559 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2900$1018 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3102$1078 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:3115$1084 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3194$1101 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:3201$1104 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3289$1123 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3377$1144 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4550 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2685$940 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8240$2677 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8228$2672 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8238$2676 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:8234$2674 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2659$934 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2643$930
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.next = (p_rst ? value<149>{0u,0u,0u,0u,0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance ? (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5125 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<148,146>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4551__CMP ? (p_unity__link__inst_2e_core__inst_2e_answer__taken ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<17,16>().val(), value<1>{0x1u}) ? value<2>{0x2u} : value<1>{0u}.concat((reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<17,16>().val()) ? value<1>{0x1u} : value<1>{0u})).val()).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<25>()).val() : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5675__o ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6744__q.curr.slice<36>().val() ? value<2>{0x2u} : value<2>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6744__q.curr.slice<37>()).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<148,146>().val())) : value<3>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4551__CMP ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4552__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6074__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6124__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4553__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6124__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4554__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6115__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5707__o) ? value<1>{0x1u} : value<1>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4555__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6107__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5707__o) ? value<1>{0x1u} : value<1>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4556__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6584__o ? value<1>{0x1u} : value<1>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4557__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5707__o ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})))))))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5125 ? value<1>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4551__CMP ? value<1>{0u} : value<1>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4551__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<143,136>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4552__CMP ? value<2>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<8>()).concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<7>().val() ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5862__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5858__o).val(), value<1>{0x1u}) ? value<5>{0x18u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5862__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5858__o).val(), value<2>{0x2u}) ? value<5>{0xeu} : value<5>{0x10u})) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5948__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5939__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5930__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5921__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5912__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5891__o).val(), value<1>{0x1u}) ? value<5>{0x12u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5948__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5939__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5930__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5921__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5912__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5891__o).val(), value<2>{0x2u}) ? value<5>{0x17u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5948__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5939__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5930__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5921__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5912__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5891__o).val(), value<3>{0x4u}) ? value<5>{0x9u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5948__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5939__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5930__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5921__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5912__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5891__o).val(), value<4>{0x8u}) ? value<5>{0x8u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5948__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5939__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5930__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5921__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5912__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5891__o).val(), value<5>{0x10u}) ? value<5>{0x11u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5948__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5939__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5930__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5921__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5912__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5891__o).val(), value<6>{0x20u}) ? value<5>{0xbu} : value<5>{0x7u})))))))).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4553__CMP ? value<2>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6072__o).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4554__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6323__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6323__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6323__o).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4555__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6426__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6426__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6426__o).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4556__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6519__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6519__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6519__o).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4557__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6623__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6623__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6623__o).val()) : value<8>{0u})))))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4556__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5707__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<135>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5195 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<135>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4551__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5843__o.slice<1>().val() : value<1>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5125 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<134>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4551__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5843__o.slice<0>().val() : value<1>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4551__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<133,128>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4552__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6074__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<133,128>().val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6123__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4553__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6123__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4554__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5707__o ? value<2>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6114__o_5b_3_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6363__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4555__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5707__o ? value<6>{0xfu} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6363__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4556__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5707__o ? value<2>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<135>().val() ? value<4>{0x7u} : value<4>{0xfu})).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6363__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4557__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6363__o : value<6>{0u})))))))).concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<134>().val() ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6744__q.curr : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5201 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<123,64>().concat(value<4>{0u}).val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5189 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<127,64>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4551__CMP ? (p_unity__link__inst_2e_core__inst_2e_answer__taken ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<127,64>().val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5824__o.slice<72,9>().val()) : value<64>{0u,0u}))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4556__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5707__o ? sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<63,55>().val(), value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<63,55>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5195 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<63,55>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4551__CMP ? (p_unity__link__inst_2e_core__inst_2e_answer__taken ? value<1>{0u}.concat((and_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<23,22>().val()), and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<106>().val()), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2811__o)) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<201,194>().val() : value<8>{0u})).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5824__o.slice<8,0>().val()) : value<9>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4551__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5836__o.slice<45,38>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5189 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<54,47>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5201 ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5746__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<50,47>().concat(value<4>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<54,47>().val()) : value<8>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5125 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<46,43>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4551__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5836__o.slice<37,34>().val() : value<4>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4551__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5836__o.slice<33,2>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5189 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<42,11>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5201 ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5723__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<38,11>().concat(value<4>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<42,11>().val()) : value<32>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5125 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<10,9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4551__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5836__o.slice<1,0>().val() : value<2>{0u}))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5125 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<8,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4551__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5833__o.slice<8,3>().val() : value<6>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4551__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5833__o.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4552__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6074__o ? value<3>{0x2u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6122__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4553__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6122__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4554__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5707__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6113__o : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4555__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5707__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6111__o : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4556__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6584__o ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4557__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5707__o ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<2,0>().val()) : value<3>{0u})))))))).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr));
	}
	// \src: top.v:3596.3-3597.28
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procdff$4981
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6744__q.next = p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__word.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$procdff$4998 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:1116$486
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left.next = (p_rst ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_n198__o);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4980 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3955$1700
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5621__q.next = (p_rst ? value<13>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5588__o);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4979 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3957$1701 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3937$1691 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5596$2013
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.next = (p_rst ? value<13>{0u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4812__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted) ? p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5588__o : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4978 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3959$1702
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5623__q.next = (p_rst ? value<13>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5592__o);
	}
	// \src: top.v:9567.3-9568.28
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procdff$4905
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.next = p_unity__link__inst_2e_core__inst_2e_memory__word.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procdff$4906 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9562$3020 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4047 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9219$2960 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9306$2987 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9286$2981 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9274$2977 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9267$2975 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9264$2974 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:9262$2973 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9321$2993 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9337$2997 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9352$3002 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9361$3005 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:9358$3004 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4037 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8246$2679 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8244$2678 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:8255$2681 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$sub$top.v:8251$2680 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4027 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4017 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$4007 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3997 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9311$2989 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9292$2983 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9277$2978 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9258$2972 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$add$top.v:9255$2971 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$sub$top.v:9249$2969 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3987 $auto$opt_reduce.cc:131:opt_pmux$5174 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9340$2998 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9237$2966 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:9230$2964 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8261$2683 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ge$top.v:8259$2682 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3977 $auto$opt_reduce.cc:131:opt_pmux$5172 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9222$2961 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3967 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3957 $auto$opt_reduce.cc:131:opt_pmux$5168 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9343$2999 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3947 $auto$opt_reduce.cc:131:opt_pmux$5166 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9347$3000 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3937 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9302$2986 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:9316$2991 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3927
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.next = (p_rst ? value<107>{0xd20000u,0u,0x8000000u,0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5163 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<106>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3928__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3572__o.slice<4>().val() : value<1>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3931__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed, p_unity__link__inst_2e_core__inst_2e_access__done) ? p_unity__link__inst_2e_core__inst_2e_access__failure.curr : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<105,102>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5165 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<105,102>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3928__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3572__o.slice<3,0>().val() : value<4>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3933__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3672__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<101,94>().concat(value<1>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<86,79>().concat(value<1>{0x1u}).val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3928__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3929__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3930__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3931__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3932__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3934__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3935__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<101,94>().concat(value<1>{0u}).val() : value<9>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3933__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3672__o ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<92,90>().val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3929__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3930__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3931__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3932__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3934__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3935__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<92,90>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3928__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3570__o.slice<4,2>().val() : value<3>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3931__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3658__o.slice<1>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5165 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<89>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3928__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3570__o.slice<1>().val() : value<1>{0u})))).concat((reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3932__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3933__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3934__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3935__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<88>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3931__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3658__o.slice<0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3930__CMP ? value<1>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3929__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<87>().val() ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<88>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3928__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3570__o.slice<0>().val() : value<1>{0u})))))).concat((ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.curr, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<201,194>().val()) ? value<1>{0x1u} : value<1>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3933__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3672__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<86,79>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3592__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3931__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<22>().val(), p_unity__link__inst_2e_core__inst_2e_access__granted) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3592__o : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<86,79>().val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3929__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3930__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3932__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3934__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3935__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<86,79>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3928__CMP ? value<8>{0u} : value<8>{0u}))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3931__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__done ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<78,39>().val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2667__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<78,39>().val() : sub_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<78,71>().val(), value<1>{0x1u}).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<70,39>().val() : add_uu<32>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<70,39>().val(), value<1>{0x1u}))).val())) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<78,39>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5165 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<78,39>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3928__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3569__o.slice<58,19>().val() : value<40>{0u,0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5163 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<38,25>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3928__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3569__o.slice<18,5>().val() : value<14>{0u}))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5163 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<24>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3928__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3569__o.slice<4>().val() : value<1>{0u}))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5163 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<23,20>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3928__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3569__o.slice<3,0>().val() : value<4>{0u}))).concat(not_u<1>(sub_uu<12>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<28,17>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<14,3>().val()).slice<11>().val())).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<28,17>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<14,3>().val()) ? value<1>{0x1u} : value<1>{0u})).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5163 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<17,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3928__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3567__o.slice<17,3>().val() : value<15>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3928__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3567__o.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3929__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<87>().val() ? value<3>{0x3u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3930__CMP ? value<3>{0x3u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3931__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__done ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? value<3>{0x7u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2667__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<23,20>().val(), value<3>{0x7u}) ? value<3>{0u} : value<3>{0x7u}) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val()))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3932__CMP ? (p_unity__link__inst_2e_core__inst_2e_group__done ? value<3>{0x5u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3933__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3672__o ? value<3>{0x6u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3934__CMP ? (p_unity__link__inst_2e_core__inst_2e_group__done ? value<3>{0x7u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3935__CMP ? (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_answer__taken, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<26>().val()) ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<2,0>().val()) : value<3>{0u}))))))))).val());
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4915 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:7103$2556
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3850__q.next = (p_rst ? value<9>{0u} : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3817__o);
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4914 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:7105$2557 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:7085$2547 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8052$2615
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.next = (p_rst ? value<9>{0u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2739__o, p_unity__link__inst_2e_core__inst_2e_answer__taken) ? p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3817__o : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4913 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:7107$2558 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:7089$2549 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2527$899 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2525$898 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$add$top.v:7087$2548
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3852__q.next = (p_rst ? value<9>{0u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word, not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6743__q.curr.slice<134>().val())) ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3852__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3852__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4912 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:7099$2554 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$sub$top.v:7093$2551 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$sub$top.v:7091$2550
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.next = (p_rst ? value<9>{0x100u} : sub_uu<9>(value<9>{0x100u}, sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3850__q.curr, p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3852__q.curr)));
	}
	// \src: top.v:7125.3-7127.37
	// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4910
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3857__data_5b_63_3a_0_5d_;
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4928 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6974$2523 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$4300 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6811$2481 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6835$2493 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6825$2488
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4057__q.next = (p_rst ? value<2>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4271__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3936__o ? value<2>{0x1u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4057__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4272__CMP ? (p_unity__link__inst_2e_bus__done ? value<2>{0x2u} : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3954__o ? value<2>{0x2u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4057__q.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4273__CMP ? value<2>{0u} : value<2>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4927 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6976$2524 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$4295 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6791$2471 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6785$2468
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.next = (p_rst ? value<1>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5151 ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4271__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr)) : value<1>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4926 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6978$2525 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$4290 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6787$2469 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5542$1998 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5540$1997 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6843$2497 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6849$2500
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4059__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4271__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample ? (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4730__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5476__q.curr.slice<13,6>().val()) ? value<1>{0x1u} : value<1>{0u}) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4059__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4272__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4059__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4273__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3975__o) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4059__q.curr) : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4925 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6980$2526 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$4285 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6793$2472 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6851$2501 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6845$2498
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4060__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4271__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? p_unity__link__inst_2e_core__inst_2e_access__more : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4060__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4272__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4060__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4273__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3975__o ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4060__q.curr : value<1>{0u}) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4060__q.curr) : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4924 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6982$2527 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$4280 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6795$2473 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6789$2470 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8026$2604 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6853$2502 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6847$2499
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4271__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__more, or_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__write, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked)) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4272__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4273__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3975__o ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr : value<1>{0u}) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr) : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4923 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6984$2528 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$4275 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6837$2494 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6827$2489
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4062__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4271__CMP ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4272__CMP ? (p_unity__link__inst_2e_bus__done ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4062__q.curr : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3954__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4062__q.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4273__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4062__q.curr : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4922 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6986$2529 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$4270 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$sub$top.v:6815$2483
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4063__q.next = (p_rst ? value<11>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4271__CMP ? value<11>{0x3ffu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4272__CMP ? sub_uu<11>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4063__q.curr, value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4273__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4063__q.curr : value<11>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4921 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6962$2517 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$4330 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6829$2490 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6817$2484 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6821$2486
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_access__failure.next = (p_rst ? value<4>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4272__CMP ? (p_unity__link__inst_2e_bus__done ? value<1>{0u}.concat((p_wb__err ? value<3>{0x4u} : value<3>{0u})).val() : value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3954__o ? value<3>{0x5u} : value<3>{0u})).val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5159 ? p_unity__link__inst_2e_core__inst_2e_access__failure.curr : value<4>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4920 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6964$2518 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$4325 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6831$2491
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4065__q.next = (p_rst ? value<64>{0u,0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4272__CMP ? (p_unity__link__inst_2e_bus__done ? p_wb__dat__i : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4065__q.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5159 ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4065__q.curr : value<64>{0u,0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4919 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6966$2519 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$4320 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6803$2477 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6833$2492 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6823$2487
	if (posedge_p_clk) {
		p_unity__link__inst_2e_bus__request.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4271__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3936__o ? value<1>{0x1u} : p_unity__link__inst_2e_bus__request.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4272__CMP ? (p_unity__link__inst_2e_bus__done ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3954__o ? value<1>{0u} : p_unity__link__inst_2e_bus__request.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4273__CMP ? p_unity__link__inst_2e_bus__request.curr : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4918 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6968$2520 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$4315 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6805$2478 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6799$2475
	if (posedge_p_clk) {
		p_wb__we.next = (p_rst ? value<1>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5151 ? p_wb__we.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4271__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3936__o ? and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__granted, p_unity__link__inst_2e_core__inst_2e_access__write) : p_wb__we.curr) : value<1>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4917 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6970$2521 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$4310 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6807$2479 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6801$2476
	if (posedge_p_clk) {
		p_wb__adr.next = (p_rst ? value<32>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5151 ? p_wb__adr.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4271__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3936__o ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample__address.curr : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<70,39>().val()) : p_wb__adr.curr) : value<32>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4916 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6972$2522 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$4305 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6809$2480 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8030$2605 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7962$2580 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7960$2579 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8040$2610 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8038$2609 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8036$2608 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8034$2607 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:8032$2606
	if (posedge_p_clk) {
		p_wb__dat__o.next = (p_rst ? value<64>{0u,0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5151 ? p_wb__dat__o.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_4271__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3936__o ? ((or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2627__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2630__o) ? value<1>{0x1u} : value<1>{0u}) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.curr : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked ? or_uu<64>(and_uu<64>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4065__q.curr, not_u<64>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.curr)), and_uu<64>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<164,101>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.curr)) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<164,101>().val())) : p_wb__dat__o.curr) : value<64>{0u,0u})));
	}
	// \src: top.v:3977.3-3979.37
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4975
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__word.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_5c_n5628__data_5b_63_3a_0_5d_;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4976 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3953$1699 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3949$1697 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ne$top.v:3947$1696
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available.next = (p_rst ? value<1>{0u} : (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5592__o) ? value<1>{0x1u} : value<1>{0u}));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4977 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3951$1698 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$sub$top.v:3945$1695 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$sub$top.v:3943$1694
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__ring__room.next = (p_rst ? value<13>{0x1000u} : sub_uu<13>(value<13>{0x1000u}, sub_uu<13>(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5621__q.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5623__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4991 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1294$528 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1284$523 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1274$518 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1278$520
	if (posedge_p_clk) {
		p_out__valid.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7114__o ? value<1>{0x1u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7104__o, p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7122__o) ? value<1>{0u} : p_out__valid.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4990 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1296$529 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1286$524 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1264$513 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$eq$top.v:1262$512 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1280$521
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_sent__ready.next = (p_rst ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7114__o ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<8>{0xffu}) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_sent__ready.curr) : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7122__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_sent__ready.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4989 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1298$530 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1252$507
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.next = (p_rst ? value<10>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7107__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n7066__q.curr.slice<50,41>().val() : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4988 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1300$531 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1254$508 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1250$506
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7169__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7107__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_n198__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7169__q.curr)));
	}
	// \src: top.v:802.3-804.40
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$5004
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7609__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n7609__data_5b_7_3a_0_5d_;
	}
	// \src: top.v:799.3-801.37
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$5005
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n7607__data_5b_7_3a_0_5d_;
	}
	// \src: top.v:755.3-757.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$5009
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7603__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n7603__data_5b_15_3a_0_5d_;
	}
	// \src: top.v:711.3-713.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$5013
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7599__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n7599__data_5b_15_3a_0_5d_;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$5014 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:632$210 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:629$209 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:622$207 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:620$206 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:627$208 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:618$205 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:611$203 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:609$202 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:616$204 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:607$201 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:600$199 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:598$198 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:605$200 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:596$197 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:589$195 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:587$194 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:594$196 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:585$193 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:578$191 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:576$190 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:583$192 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:574$189 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:567$187 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:565$186 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:572$188 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:563$185 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:556$183 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:554$182 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:561$184 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:552$181 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:545$179 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:543$178 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:550$180 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:541$177 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:534$175 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:532$174 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:539$176 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:530$173 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:523$171 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:521$170 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:528$172 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:519$169 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:512$167 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:510$166 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:517$168 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:508$165 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:501$163 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:499$162 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:506$164 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:497$161 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:490$159 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:488$158 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:495$160 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:486$157 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:479$155 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:477$154 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:484$156 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:475$153 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:468$151 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:466$150 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:473$152 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:464$149 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:457$147 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:455$146 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:462$148 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:453$145 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:446$143 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:444$142 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:451$144 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:442$141 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:435$139 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:433$138 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:440$140 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:431$137 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:424$135 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:422$134 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:429$136 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:420$133 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:413$131 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:411$130 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:418$132
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.next = (p_rst ? value<20>{0u} : (and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<5>{0x13u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<19>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<19>().val())).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<5>{0x12u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<18>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<18>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<5>{0x11u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<17>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<17>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<5>{0x10u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<16>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<16>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xfu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<15>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<15>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xeu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<14>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<14>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xdu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<13>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<13>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xcu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<12>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<12>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xbu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<11>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<11>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xau}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<10>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<10>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0x9u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<9>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<9>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0x8u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<8>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<8>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<3>{0x7u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<7>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<7>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<3>{0x6u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<6>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<6>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<3>{0x5u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<5>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<5>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<3>{0x4u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<4>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<4>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<2>{0x3u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<3>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<3>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<2>{0x2u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<2>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<2>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<1>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<1>().val()))).concat((and_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<0>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<0>().val()))).val());
	}
	// \src: top.v:670.3-671.28
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$5015
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__losses.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7609__data.curr;
	}
	// \src: top.v:667.3-668.29
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$5016
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7603__data.curr;
	}
	// \src: top.v:664.3-665.29
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$5017
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7599__data.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$5018 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:644$216
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.next = (p_rst ? value<5>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7586__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$5019 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:642$215
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.next = (p_rst ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7585__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$5020 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:640$214
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7586__q.next = (p_rst ? value<5>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7584__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$5021 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:638$213
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7585__q.next = (p_rst ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7583__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$5022 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:636$212 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:409$129 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:405$127 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$add$top.v:397$123
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7584__q.next = (p_rst ? value<5>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick.curr ? value<5>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7583__q.curr ? add_uu<5>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7584__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7584__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$5023 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:634$211 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:407$128 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:401$125 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:403$126 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:399$124
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7583__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick.curr ? value<1>{0x1u} : (and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7584__q.curr, value<5>{0x13u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7583__q.curr) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n7583__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$procdff$4999 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$ternary$top.v:1041$469 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$ternary$top.v:1037$467
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n7220__o ? value<1>{0x1u} : value<1>{0u}));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$procdff$5000 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$ternary$top.v:1043$470 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$ternary$top.v:1039$468 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$sub$top.v:1033$465
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n7234__q.next = (p_rst ? value<6>{0x31u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n7220__o ? value<6>{0x31u} : sub_uu<6>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n7234__q.curr, value<1>{0x1u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4971 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4957$1792
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4108__q.next = (p_rst ? value<20>{0xfffffu} : p_trigger);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4970 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4959$1793
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4109__q.next = (p_rst ? value<20>{0xfffffu} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4108__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4969 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4961$1794
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4110__q.next = (p_rst ? value<20>{0xfffffu} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4109__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4968 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:6265$2236 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4521 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5801$2096 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5793$2092 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4537 $auto$opt_reduce.cc:131:opt_pmux$5144 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5819$2105 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5817$2104 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5815$2103 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5835$2113 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5831$2111 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5863$2127 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5859$2125 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5857$2124 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5855$2123 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5875$2133 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:6089$2220
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5472__q.next = (p_rst ? value<4>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4402__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4299__o ? value<4>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4284__o ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4534__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4535__CMP).val()) ? value<4>{0x9u} : value<4>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5472__q.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4403__CMP ? value<4>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4404__CMP ? (and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3775__q.curr.slice<92,90>().val(), value<2>{0x3u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4707__o) ? value<4>{0x8u} : value<4>{0x3u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4405__CMP ? value<4>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4406__CMP ? value<4>{0x5u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4407__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4689__o ? value<3>{0x3u}.concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room.curr ? value<1>{0u} : value<1>{0x1u})).val() : value<4>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4408__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3910__o ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3975__o ? value<4>{0x7u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5102__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5476__q.curr.slice<13,6>().val()) ? value<4>{0x7u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5472__q.curr)) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5472__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4409__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4707__o ? value<4>{0x9u} : value<4>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4410__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out ? value<4>{0x9u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5472__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4411__CMP ? value<4>{0u} : value<4>{0u})))))))))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4967 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:6267$2237 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4509 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5803$2097 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5664$2045 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5795$2093
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5473__q.next = (p_rst ? value<2>{0x2u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5139 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5473__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4402__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4299__o ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5484__q.curr ? value<1>{0u} : value<1>{0x1u})).val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4284__o ? value<2>{0x2u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5473__q.curr)) : value<2>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4966 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:6269$2238 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4497 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5805$2098 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5797$2094
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.next = (p_rst ? value<5>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5139 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4402__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4299__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.curr : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4284__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val() : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5474__q.curr)) : value<5>{0u})));
	}
	// \src: top.v:6296.3-6297.30
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4965
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5476__q.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5502__data.curr;
	}
	// \src: top.v:6299.3-6300.27
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4964
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5506__data.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4963 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:6271$2239 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4485 $auto$opt_reduce.cc:131:opt_pmux$5136 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:6091$2221 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:6085$2218 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:6083$2217 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5807$2099 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5799$2095 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4533 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5774$2088 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5772$2087 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5769$2086 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5767$2085 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5764$2084 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5761$2083 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5759$2082 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5756$2081 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5754$2080 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5751$2079 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5749$2078 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5746$2077 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5744$2076 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5741$2075 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5739$2074 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5736$2073 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5734$2072 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5731$2071 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5729$2070 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5726$2069 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5724$2068 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5721$2067 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5719$2066 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5716$2065 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5714$2064 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5711$2063 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5709$2062 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5706$2061 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5704$2060 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5701$2059 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5699$2058 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5696$2057 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5694$2056 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5691$2055 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5689$2054 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5686$2053 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5684$2052 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5681$2051 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5679$2050 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5676$2049 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5674$2048 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5672$2047
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.next = (p_rst ? value<20>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4410__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4850__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr : or_uu<20>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5143__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5150__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5156__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5162__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5168__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5174__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5180__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5186__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5192__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5198__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5204__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5210__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5216__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5222__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5228__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5234__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5240__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5246__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5252__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5257__o).val())) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4403__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4404__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4405__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4406__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4407__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4408__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4409__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4411__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4402__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4299__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4284__o ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4534__CMP ? value<20>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4535__CMP ? and_uu<20>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr, not_u<20>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<5>{0x13u}) ? value<1>{0x1u} : value<1>{0u}).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<5>{0x12u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<5>{0x11u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<5>{0x10u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<4>{0xfu}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<4>{0xeu}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<4>{0xdu}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<4>{0xcu}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<4>{0xbu}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<4>{0xau}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<4>{0x8u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<3>{0x7u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<3>{0x6u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<3>{0x5u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<3>{0x4u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<2>{0x3u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<2>{0x2u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val(), value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u})).concat((logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<73,69>().val()) ? value<1>{0x1u} : value<1>{0u})).val())) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr)) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr)) : value<20>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4962 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:6273$2240 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4473 $auto$opt_reduce.cc:131:opt_pmux$5134 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:6087$2219 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:6093$2222 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5981$2176
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.next = (p_rst ? value<20>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4410__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4850__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out) ? or_uu<20>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5143__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5150__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5156__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5162__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5168__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5174__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5180__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5186__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5192__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5198__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5204__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5210__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5216__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5222__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5228__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5234__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5240__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5246__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5252__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5257__o).val()) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4402__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4403__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4404__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4405__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4406__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4407__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4408__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4409__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4411__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr : value<20>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4961 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4955$1791 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4953$1790 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4951$1789 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5420$1962 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5415$1960 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5410$1958 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5405$1956 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5400$1954 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5395$1952 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5390$1950 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5385$1948 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5380$1946 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5375$1944 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5370$1942 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5365$1940 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5360$1938 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5355$1936 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5350$1934 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5345$1932 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5340$1930 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5335$1928 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5330$1926 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5325$1924 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5320$1922 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:4949$1788 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4947$1787 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4945$1786 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4943$1785
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__trigger.next = (p_rst ? value<20>{0u} : and_uu<20>(or_uu<20>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__trigger.curr, and_uu<20>(and_uu<20>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4109__q.curr, not_u<20>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4110__q.curr)), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5479__q.curr)), not_u<20>(or_uu<20>((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4308__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u}).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4314__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4324__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4329__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4334__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4339__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4344__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4349__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4354__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4359__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4364__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4369__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4374__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4379__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4384__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4389__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4394__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4399__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4404__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4411__o : value<1>{0u})).val(), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4407__o))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4960 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5176$1860 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5170$1857 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5160$1854 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5150$1851 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5140$1848 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5130$1845 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5120$1842 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5110$1839 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5100$1836 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5090$1833 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5080$1830 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5070$1827 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5060$1824 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5050$1821 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5040$1818 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5030$1815 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5020$1812 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5010$1809 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5000$1806 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4990$1803 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4980$1800
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5482__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<0>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<1>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<2>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<3>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<4>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<5>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<6>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<7>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<8>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<9>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<10>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<11>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<12>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<13>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<14>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<15>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<16>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<17>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<18>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<19>().val() ? value<1>{0x1u} : value<1>{0u})))))))))))))))))))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4959 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5178$1861 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5172$1858 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5162$1855 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5152$1852 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5142$1849 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5132$1846 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5122$1843 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5112$1840 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5102$1837 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5092$1834 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5082$1831 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5072$1828 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5062$1825 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5052$1822 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5042$1819 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5032$1816 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5022$1813 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5012$1810 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5002$1807 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4992$1804 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4982$1801
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5483__q.next = (p_rst ? value<5>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<0>().val() ? value<5>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<1>().val() ? value<5>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<2>().val() ? value<5>{0x2u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<3>().val() ? value<5>{0x3u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<4>().val() ? value<5>{0x4u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<5>().val() ? value<5>{0x5u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<6>().val() ? value<5>{0x6u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<7>().val() ? value<5>{0x7u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<8>().val() ? value<5>{0x8u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<9>().val() ? value<5>{0x9u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<10>().val() ? value<5>{0xau} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<11>().val() ? value<5>{0xbu} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<12>().val() ? value<5>{0xcu} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<13>().val() ? value<5>{0xdu} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<14>().val() ? value<5>{0xeu} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<15>().val() ? value<5>{0xfu} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<16>().val() ? value<5>{0x10u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<17>().val() ? value<5>{0x11u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<18>().val() ? value<5>{0x12u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<19>().val() ? value<5>{0x13u} : value<5>{0u})))))))))))))))))))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4958 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5180$1862 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5174$1859 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5164$1856 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5154$1853 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5144$1850 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5134$1847 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5124$1844 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5114$1841 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5104$1838 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5094$1835 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5084$1832 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5074$1829 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5064$1826 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5054$1823 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5044$1820 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5034$1817 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5024$1814 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5014$1811 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5004$1808 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4994$1805 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4984$1802
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5484__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<0>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<0>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<1>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<1>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<2>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<2>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<3>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<3>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<4>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<4>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<5>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<5>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<6>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<6>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<7>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<7>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<8>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<8>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<9>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<9>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<10>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<10>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<11>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<11>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<12>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<12>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<13>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<13>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<14>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<14>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<15>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<16>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<16>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<17>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<17>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<18>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<18>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4115__o.slice<19>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<19>().val() : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5484__q.curr)))))))))))))))))))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4957 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:6275$2241 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4461 $auto$opt_reduce.cc:131:opt_pmux$5132
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5485__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4411__CMP ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4409__CMP ? value<1>{0x1u} : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4402__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4403__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4404__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4405__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4406__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4407__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4408__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4410__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5485__q.curr : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4956 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:6277$2242 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4449 $auto$opt_reduce.cc:131:opt_pmux$5130
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost__kept.next = (p_rst ? value<8>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4403__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost.curr : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4402__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4404__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4405__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4406__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4407__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4408__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4409__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4410__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4411__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost__kept.curr : value<8>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4955 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5500$1979 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5496$1977
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5487__q.next = (p_rst ? value<32>{0u} : add_uu<32>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5487__q.curr, value<1>{0x1u}));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4954 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5494$1976 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5490$1974 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5492$1975
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5488__q.next = (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5473__q.curr) ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<7,0>().val(), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost__kept.curr) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<7,0>().val());
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4953 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:6279$2243 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4437 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5843$2117
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.next = (p_rst ? value<8>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4408__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4730__o : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5123 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4402__CMP ? value<8>{0u} : value<8>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4952 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:6281$2244 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4425 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5865$2128
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5490__q.next = (p_rst ? value<8>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4408__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3910__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5102__o : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5490__q.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5123 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5490__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4402__CMP ? value<8>{0u} : value<8>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4951 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:6283$2245 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4413 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5849$2120 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5867$2129 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5847$2119
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4408__CMP ? (and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n4065__q.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__word.curr), p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3910__o) ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_5123 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4402__CMP ? value<1>{0u} : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4950 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:6285$2246 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4401 $auto$opt_reduce.cc:131:opt_pmux$5120 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5861$2126 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5869$2130 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5837$2114 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5833$2112
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4408__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3975__o, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3910__o) ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4407__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4689__o ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room.curr ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr : value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4403__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4404__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4405__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4406__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4409__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4410__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4411__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4402__CMP ? value<1>{0u} : value<1>{0u})))));
	}
	// \src: top.v:6344.3-6345.26
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4949
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__word.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__read.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4948 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5482$1971 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5480$1970 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5474$1969
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5496__q.next = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5476__q.curr.slice<3>().val() ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5476__q.curr.slice<13,6>().val(), value<2>{0x2u}) : add_uu<9>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5476__q.curr.slice<13,6>().val(), value<1>{0x1u}));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4947 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5488$1973 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ge$top.v:5486$1972
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room.next = (ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__ring__room.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5496__q.curr) ? value<1>{0x1u} : value<1>{0u});
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4946 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5470$1968 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5468$1967 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$lt$top.v:5456$1965 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:6569$2313 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4339 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4334 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4335_CMP0 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4336_CMP0 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4337_CMP0 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4338_CMP0 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4344 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4349 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4354 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4359
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_group__is__set.next = (p_rst ? value<1>{0u} : (lt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2557__q.curr.slice<76,69>().val(), value<5>{0x14u}) ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4617__o.slice<4>().val() ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4340__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<19>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4341__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<18>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4342__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<17>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4343__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<16>().val() : value<1>{0u})))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4617__o.slice<3,2>().val(), value<2>{0x3u}) ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4340__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4341__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<14>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4342__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<13>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4343__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<12>().val() : value<1>{0u})))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4617__o.slice<3,2>().val(), value<2>{0x2u}) ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4340__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<11>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4341__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<10>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4342__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4343__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<8>().val() : value<1>{0u})))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4617__o.slice<3,2>().val(), value<1>{0x1u}) ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4340__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<7>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4341__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<6>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4342__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4343__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<4>().val() : value<1>{0u})))) : (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4617__o.slice<3,2>().val()) ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4340__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4341__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<2>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4342__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<1>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4343__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<0>().val() : value<1>{0u})))) : value<1>{0u}))))) : value<1>{0u}));
	}
	// \src: top.v:6356.3-6357.29
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4945
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample__address.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_address__read.curr;
	}
	// \src: top.v:6394.3-6396.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4944
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5502__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n5502__data_5b_13_3a_0_5d_;
	}
	// \src: top.v:6438.3-6440.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4940
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n5506__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n5506__data_5b_9_3a_0_5d_;
	}
	// \src: top.v:6448.3-6450.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4936
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_address__read.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n5509__data_5b_31_3a_0_5d_;
	}
	// \src: top.v:6458.3-6460.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4932
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__read.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n5512__data_5b_63_3a_0_5d_;
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4987 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$4795
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7170__data.next = (p_unity__link__inst_2e_core__inst_2e_n198__o ? i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_1326_24_540__DATA : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n7170__data.curr);
	}
	// connection
	p_out__data = p_unity__link__inst_2e_core__inst_2e_tx__entry.slice<7,0>().val();
	// connection
	p_wb__sel = value<8>{0xffu};
	return converged;
}

} // namespace cxxrtl_design

