// b4e6222e94401ccd names what this was made from: unity_link_fifo in its configuration 'default', by GHDL and Yosys 0.70.0.
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
// \src: top.v:13233.1-13326.10
struct p_unity__link__fifo : public module {
	// \hdlname: unity_link_inst core_inst request_executor_inst memory_kept
	// \src: top.v:6702.15-6702.26
	wire<32> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2144_q
	// \src: top.v:9714.15-9714.22
	wire<142> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3362_q
	// \src: top.v:7398.14-7398.21
	wire<75> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst committed
	// \src: top.v:3684.15-3684.24
	wire<11> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed;
	// \hdlname: unity_link_inst core_inst request_executor_inst ring_room
	// \src: top.v:6659.17-6659.26
	wire<9> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room;
	// \hdlname: unity_link_inst core_inst frame_writer_inst sample_word
	// \src: top.v:1748.18-1748.29
	wire<32> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__word;
	// \hdlname: unity_link_inst core_inst frame_writer_inst sample_available
	// \src: top.v:1747.11-1747.27
	wire<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available;
	// \hdlname: unity_link_inst core_inst frame_writer_inst response_word
	// \src: top.v:1746.18-1746.31
	wire<32> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst n5059_q
	// \src: top.v:3703.14-3703.21
	wire<11> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5059__q;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst n5061_q
	// \src: top.v:3705.14-3705.21
	wire<11> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5061__q;
	// \hdlname: unity_link_inst core_inst response_ring_inst n3439_q
	// \src: top.v:6569.13-6569.20
	wire<9> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3439__q;
	// \hdlname: unity_link_inst core_inst response_ring_inst n3437_q
	// \src: top.v:6567.13-6567.20
	wire<9> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3437__q;
	// \hdlname: unity_link_inst core_inst response_ring_inst committed
	// \src: top.v:6548.14-6548.23
	wire<9> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6493_q
	// \src: top.v:1330.14-1330.21
	wire<26> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst tick_inst n6661_q
	// \src: top.v:843.13-843.20
	wire<6> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6661__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3697_q
	// \src: top.v:3882.14-3882.21
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3697__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3696_q
	// \src: top.v:3881.14-3881.21
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3696__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3695_q
	// \src: top.v:3880.14-3880.21
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3695__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst group_state
	// \src: top.v:3814.14-3814.25
	wire<10> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst is_set
	// \src: top.v:3823.15-3823.21
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst due_by_timer
	// \src: top.v:3824.15-3824.27
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst due_by_trigger
	// \src: top.v:3825.15-3825.29
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__trigger;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst tick
	// \src: top.v:3834.8-3834.12
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst lost
	// \src: top.v:3840.14-3840.18
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst lost_kept
	// \src: top.v:3841.14-3841.23
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost__kept;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst asked
	// \src: top.v:3844.14-3844.19
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst changed
	// \src: top.v:3846.8-3846.15
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst failed
	// \src: top.v:3847.8-3847.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst last_read
	// \src: top.v:3848.15-3848.24
	wire<32> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__read;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst last_word
	// \src: top.v:3849.15-3849.24
	wire<32> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__word;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst address_read
	// \src: top.v:3850.14-3850.26
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_address__read;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst enough_room
	// \src: top.v:3853.8-3853.19
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3652_q
	// \src: top.v:6210.14-6210.21
	wire<32> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3650_q
	// \src: top.v:6208.14-6208.21
	wire<11> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3650__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3649_q
	// \src: top.v:6207.7-6207.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3647_q
	// \src: top.v:6205.7-6205.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3646_q
	// \src: top.v:6204.7-6204.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3644_q
	// \src: top.v:6202.13-6202.20
	wire<2> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst exclusive
	// \src: top.v:6110.8-6110.17
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive;
	// \hdlname: unity_link_inst core_inst bus_master_inst for_sample
	// \src: top.v:6107.8-6107.18
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample;
	// \hdlname: unity_link_inst core_inst bus_master_inst sample_address
	// \src: top.v:6091.17-6091.31
	wire<8> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample__address;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6179_q
	// \src: top.v:2247.14-2247.21
	wire<32> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6179__q;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6178_q
	// \src: top.v:2246.14-2246.21
	wire<93> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst kept_valid
	// \src: top.v:23.8-23.18
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst kept_index
	// \src: top.v:24.14-24.24
	wire<4> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst kept_divisor
	// \src: top.v:25.15-25.27
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst kept_counter
	// \src: top.v:26.15-26.27
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst kept_losses
	// \src: top.v:27.14-27.25
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__losses;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n925_q
	// \src: top.v:11354.14-11354.20
	wire<62> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6597_data
	// \src: top.v:1016.13-1016.23
	wire<10> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6597__data;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6596_q
	// \src: top.v:1015.7-1015.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6596__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6589_q
	// \src: top.v:1010.13-1010.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6589__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6588_q
	// \src: top.v:1009.13-1009.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6588__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst bypass
	// \src: top.v:969.14-969.20
	wire<10> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst count
	// \src: top.v:963.14-963.19
	wire<9> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst n6639_q
	// \src: top.v:896.7-896.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6639__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst count
	// \src: top.v:11999.14-11999.19
	wire<9> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst bypass
	// \src: top.v:12005.14-12005.20
	wire<9> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n333_q
	// \src: top.v:12045.13-12045.19
	wire<8> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n333__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n334_q
	// \src: top.v:12046.13-12046.19
	wire<8> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n334__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n341_q
	// \src: top.v:12051.7-12051.13
	wire<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n341__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n342_data
	// \src: top.v:12052.13-12052.22
	wire<9> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n342__data;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst its_mark
	// \src: top.v:876.14-876.22
	wire<2> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst has_left
	// \src: top.v:875.8-875.16
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6972_q
	// \src: top.v:178.7-178.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6972__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6973_q
	// \src: top.v:179.13-179.20
	wire<4> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6973__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6974_q
	// \src: top.v:180.7-180.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6974__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6975_q
	// \src: top.v:181.13-181.20
	wire<4> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6975__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6988_data
	// \src: top.v:188.14-188.24
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6988__data;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6992_data
	// \src: top.v:189.14-189.24
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6992__data;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6998_data
	// \src: top.v:191.13-191.23
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6998__data;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4952_data
	// \src: top.v:4466.13-4466.23
	wire<10> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4952__data;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4948_data
	// \src: top.v:4465.14-4465.24
	wire<14> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4948__data;
	// \hdlname: unity_link_inst core_inst with_groups_ring_room
	// \src: top.v:12475.15-12475.36
	wire<11> p_unity__link__inst_2e_core__inst_2e_with__groups__ring__room;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4942_q
	// \src: top.v:4461.13-4461.20
	wire<9> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4942__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4936_q
	// \src: top.v:4457.13-4457.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4936__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4934_q
	// \src: top.v:4455.13-4455.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4934__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4933_q
	// \src: top.v:4454.14-4454.21
	wire<32> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4933__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4931_q
	// \src: top.v:4452.7-4452.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4931__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4930_q
	// \src: top.v:4451.7-4451.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4930__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4929_q
	// \src: top.v:4450.13-4450.20
	wire<4> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4928_q
	// \src: top.v:4449.7-4449.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4928__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4925_q
	// \src: top.v:4446.14-4446.21
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4922_q
	// \src: top.v:4444.14-4444.21
	wire<14> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4922__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4920_q
	// \src: top.v:4443.13-4443.20
	wire<4> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4919_q
	// \src: top.v:4442.13-4442.20
	wire<2> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4919__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4918_q
	// \src: top.v:4441.13-4441.20
	wire<4> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q;
	// \hdlname: unity_link_inst core_inst sent_ready
	// \src: top.v:12382.8-12382.18
	wire<1> p_unity__link__inst_2e_core__inst_2e_sent__ready;
	// \hdlname: unity_link_inst core_inst group_is_set
	// \src: top.v:12352.8-12352.20
	wire<1> p_unity__link__inst_2e_core__inst_2e_group__is__set;
	// \hdlname: unity_link_inst core_inst access_failure
	// \src: top.v:12350.14-12350.28
	wire<4> p_unity__link__inst_2e_core__inst_2e_access__failure;
	// \hdlname: unity_link_inst core_inst memory_word
	// \src: top.v:12330.15-12330.26
	wire<32> p_unity__link__inst_2e_core__inst_2e_memory__word;
	// \hdlname: unity_link_inst core_inst character_valid
	// \src: top.v:12301.8-12301.23
	wire<1> p_unity__link__inst_2e_core__inst_2e_character__valid;
	// \hdlname: unity_link_inst core_inst character_in
	// \src: top.v:12300.14-12300.26
	wire<9> p_unity__link__inst_2e_core__inst_2e_character__in;
	// \hdlname: unity_link_inst core_inst fifo_out_valid
	// \src: top.v:12298.8-12298.22
	wire<1> p_unity__link__inst_2e_core__inst_2e_fifo__out__valid;
	// \hdlname: unity_link_inst core_inst flush
	// \src: top.v:12290.11-12290.16
	wire<1> p_unity__link__inst_2e_core__inst_2e_flush;
	// \src: top.v:13254.18-13254.26
	/*output*/ wire<32> p_wb__dat__o;
	// \src: top.v:13253.17-13253.23
	/*output*/ wire<8> p_wb__adr;
	// \src: top.v:13252.17-13252.23
	/*output*/ value<4> p_wb__sel;
	// \src: top.v:13251.11-13251.16
	/*output*/ wire<1> p_wb__we;
	// \src: top.v:13250.11-13250.17
	/*output*/ wire<1> p_wb__stb;
	// \src: top.v:13249.11-13249.17
	/*output*/ value<1> p_wb__cyc;
	// \src: top.v:13248.11-13248.20
	/*output*/ wire<1> p_out__flush;
	// \src: top.v:13247.11-13247.20
	/*output*/ wire<1> p_out__valid;
	// \src: top.v:13246.17-13246.25
	/*output*/ value<8> p_out__data;
	// \src: top.v:13245.11-13245.19
	/*output*/ wire<1> p_in__ready;
	// \src: top.v:13244.11-13244.19
	/*input*/ value<1> p_wb__stall;
	// \src: top.v:13243.11-13243.17
	/*input*/ value<1> p_wb__err;
	// \src: top.v:13242.11-13242.17
	/*input*/ value<1> p_wb__ack;
	// \src: top.v:13241.18-13241.26
	/*input*/ value<32> p_wb__dat__i;
	// \src: top.v:13240.18-13240.25
	/*input*/ value<16> p_trigger;
	// \src: top.v:13239.11-13239.20
	/*input*/ value<1> p_out__ready;
	// \src: top.v:13238.11-13238.19
	/*input*/ value<1> p_in__valid;
	// \src: top.v:13237.11-13237.18
	/*input*/ value<1> p_in__lost;
	// \src: top.v:13236.17-13236.24
	/*input*/ value<8> p_in__data;
	// \src: top.v:13235.11-13235.14
	/*input*/ value<1> p_rst;
	// \src: top.v:13234.11-13234.14
	/*input*/ value<1> p_clk;
	value<1> prev_p_clk;
	bool posedge_p_clk() const {
		return !prev_p_clk.slice<0>().val() && p_clk.slice<0>().val();
	}
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst last
	// \src: top.v:5987.14-5987.18
	memory<32> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last { 1024u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6180
	// \src: top.v:3391.13-3391.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6180 { 64u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst losses
	// \src: top.v:640.13-640.19
	memory<8> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses { 16u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst counters
	// \src: top.v:612.14-612.22
	memory<16> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters { 16u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst divisors
	// \src: top.v:584.14-584.22
	memory<16> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors { 16u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6182
	// \src: top.v:3461.13-3461.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6182 { 64u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6184
	// \src: top.v:3531.13-3531.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6184 { 64u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6186
	// \src: top.v:3601.13-3601.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6186 { 64u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst list
	// \src: top.v:5977.13-5977.17
	memory<8> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_list { 512u };
	// \hdlname: unity_link_inst core_inst response_ring_inst memory
	// \src: top.v:6632.14-6632.20
	memory<32> memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory { 256u };
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst memory
	// \src: top.v:3768.14-3768.20
	memory<32> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_memory { 1024u };
	// \hdlname: unity_link_inst core_inst tx_fifo_inst memory
	// \no_rw_check: 1
	// \src: top.v:1139.36-1139.42
	memory<10> memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory { 256u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst state_memory
	// \src: top.v:5949.13-5949.25
	memory<10> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory { 16u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst settings_memory
	// \src: top.v:5921.14-5921.29
	memory<14> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory { 16u };
	// \hdlname: unity_link_inst core_inst rx_fifo_inst memory
	// \no_rw_check: 1
	// \src: top.v:12175.36-12175.42
	memory<9> memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory { 256u };
	// \hdlname: unity_link_inst core_inst request_memory_inst memory
	// \src: top.v:9089.14-9089.20
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
		if (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__word.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5059__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5061__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3439__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3437__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6661__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3697__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3696__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3695__q.commit(observer)) changed = true;
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
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3650__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample__address.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6179__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__losses.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6597__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6596__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6589__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6588__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6639__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n333__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n334__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n341__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n342__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6972__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6973__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6974__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6975__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6988__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6992__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6998__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4952__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4948__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__ring__room.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4942__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4936__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4934__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4933__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4931__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4930__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4928__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4922__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4919__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_sent__ready.commit(observer)) changed = true;
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
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_list.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory.commit(observer)) changed = true;
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
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0xfu}, value<4>{0x7u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x2u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_1), std::end(mem_init_1), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6180.data[0]);
	static const value<8> mem_init_2[16] {
		value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u},
		value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u},
		value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u},
		value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u}, value<8>{0x00u},
	};
	std::copy(std::begin(mem_init_2), std::end(mem_init_2), &memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses.data[0]);
	static const value<16> mem_init_3[16] {
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
	};
	std::copy(std::begin(mem_init_3), std::end(mem_init_3), &memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters.data[0]);
	static const value<16> mem_init_4[16] {
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
		value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u}, value<16>{0x0000u},
	};
	std::copy(std::begin(mem_init_4), std::end(mem_init_4), &memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors.data[0]);
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
	std::copy(std::begin(mem_init_5), std::end(mem_init_5), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6182.data[0]);
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
	std::copy(std::begin(mem_init_6), std::end(mem_init_6), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6184.data[0]);
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
	std::copy(std::begin(mem_init_7), std::end(mem_init_7), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6186.data[0]);
	static const value<10> mem_init_8[16] {
		value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u},
		value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u},
		value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u},
		value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u}, value<10>{0x000u},
	};
	std::copy(std::begin(mem_init_8), std::end(mem_init_8), &memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory.data[0]);
	static const value<14> mem_init_9[16] {
		value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u},
		value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u},
		value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u},
		value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u}, value<14>{0x0000u},
	};
	std::copy(std::begin(mem_init_9), std::end(mem_init_9), &memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory.data[0]);
}

bool p_unity__link__fifo::eval(performer *performer) {
	bool converged = true;
	bool posedge_p_clk = this->posedge_p_clk();
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1482_o
	// \src: top.v:9384.8-9384.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1482__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5485_o
	// \src: top.v:1935.8-1935.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5485__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5476_o
	// \src: top.v:1933.8-1933.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5476__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2562_o
	// \src: top.v:6870.8-6870.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2562__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5467_o
	// \src: top.v:1931.8-1931.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5467__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2542_o
	// \src: top.v:6866.8-6866.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2542__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4227__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1524_o
	// \src: top.v:9399.8-9399.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1524__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1526_o
	// \src: top.v:9400.8-9400.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1526__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1527_o
	// \src: top.v:9401.8-9401.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1530_o
	// \src: top.v:9402.8-9402.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1530__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1556_o
	// \src: top.v:9410.8-9410.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5449_o
	// \src: top.v:1927.8-1927.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5449__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1584_o
	// \src: top.v:9419.8-9419.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1601_o
	// \src: top.v:9421.13-9421.20
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5437_o
	// \src: top.v:1923.8-1923.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5437__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1612_o
	// \src: top.v:9425.8-9425.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1612__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1618_o
	// \src: top.v:9428.8-9428.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1618__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1621_o
	// \src: top.v:9429.8-9429.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1621__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1624_o
	// \src: top.v:9430.8-9430.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1624__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6393_o
	// \src: top.v:1274.14-1274.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6393__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3279_o
	// \src: top.v:7347.8-7347.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3028_o
	// \src: top.v:7147.15-7147.22
	value<14> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3028__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4342__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1643_o
	// \src: top.v:9440.14-9440.21
	value<9> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1643__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4341__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5383_o
	// \src: top.v:1908.8-1908.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5383__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6058_o
	// \src: top.v:2176.13-2176.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6058__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1679_o
	// \src: top.v:9474.16-9474.23
	value<117> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1679__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1682_o
	// \src: top.v:9477.8-9477.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1682__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5374_o
	// \src: top.v:1906.8-1906.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5374__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1691_o
	// \src: top.v:9483.8-9483.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1698_o
	// \src: top.v:9489.8-9489.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1698__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1701_o
	// \src: top.v:9491.8-9491.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1701__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1702_o
	// \src: top.v:9492.8-9492.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1703_o
	// \src: top.v:9493.8-9493.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1703__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5365_o
	// \src: top.v:1904.8-1904.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5365__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5356_o
	// \src: top.v:1902.8-1902.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5356__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5347_o
	// \src: top.v:1900.8-1900.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5347__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5346_o
	// \src: top.v:1899.8-1899.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5346__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5144_o
	// \src: top.v:1806.8-1806.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5144__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1760_o
	// \src: top.v:9515.8-9515.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1760__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2398_o
	// \src: top.v:6793.8-6793.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2398__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5340_o
	// \src: top.v:1895.8-1895.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5340__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5337_o
	// \src: top.v:1893.8-1893.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5337__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4340__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5326_o
	// \src: top.v:1890.8-1890.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5326__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5325_o
	// \src: top.v:1889.8-1889.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5325__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1794_o
	// \src: top.v:9534.8-9534.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1794__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1797_o
	// \src: top.v:9536.8-9536.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1797__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5322_o
	// \src: top.v:1887.8-1887.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5322__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1803_o
	// \src: top.v:9540.8-9540.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1803__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1804_o
	// \src: top.v:9541.8-9541.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1804__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1807_o
	// \src: top.v:9543.8-9543.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1807__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4339__CMP;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2372_o
	// \src: top.v:6778.8-6778.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2372__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5297_o
	// \src: top.v:1879.8-1879.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5297__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2348_o
	// \src: top.v:6770.8-6770.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5293_o
	// \src: top.v:1878.8-1878.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5293__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2345_o
	// \src: top.v:6768.8-6768.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3259_o
	// \src: top.v:7333.8-7333.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3259__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1851_o
	// \src: top.v:9567.8-9567.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1851__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1853_o
	// \src: top.v:9568.8-9568.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1853__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1857_o
	// \src: top.v:9571.8-9571.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5278_o
	// \src: top.v:1873.14-1873.21
	value<2> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5278__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2326_o
	// \src: top.v:6759.8-6759.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2326__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2319_o
	// \src: top.v:6758.8-6758.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2315_o
	// \src: top.v:6756.8-6756.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2315__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1895_o
	// \src: top.v:9585.8-9585.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1901_o
	// \src: top.v:9589.8-9589.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1901__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1907_o
	// \src: top.v:9593.8-9593.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3476__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3478__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1948_o
	// \src: top.v:9615.8-9615.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1948__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1954_o
	// \src: top.v:9616.8-9616.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1954__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1962_o
	// \src: top.v:9618.8-9618.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1962__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3479__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3480__CMP;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2282_o
	// \src: top.v:6737.8-6737.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3481__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1973_o
	// \src: top.v:9627.8-9627.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1973__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2254_o
	// \src: top.v:6727.8-6727.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2254__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4563_o
	// \src: top.v:4276.8-4276.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4563__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2006_o
	// \src: top.v:9645.8-9645.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2006__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2229_o
	// \src: top.v:6717.8-6717.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2229__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4368_o
	// \src: top.v:4185.8-4185.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4368__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2217_o
	// \src: top.v:6713.8-6713.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2217__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3249_o
	// \src: top.v:7328.8-7328.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2214_o
	// \src: top.v:6711.8-6711.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2214__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5141_o
	// \src: top.v:1804.8-1804.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5141__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4574_o
	// \src: top.v:4281.8-4281.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4576_o
	// \src: top.v:4282.8-4282.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4576__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4578_o
	// \src: top.v:4283.8-4283.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4578__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2065_o
	// \src: top.v:9677.14-9677.21
	value<10> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2065__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6019_o
	// \src: top.v:2159.8-2159.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6019__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst failed
	// \src: top.v:6701.8-6701.14
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed;
	// \hdlname: unity_link_inst core_inst request_executor_inst last_word
	// \src: top.v:6699.8-6699.17
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word;
	// \hdlname: unity_link_inst core_inst request_executor_inst is_masked
	// \src: top.v:6697.8-6697.17
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked;
	// \hdlname: unity_link_inst core_inst request_executor_inst is_queue
	// \src: top.v:6696.8-6696.16
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2085_o
	// \src: top.v:9697.16-9697.23
	value<142> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2085__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2087_o
	// \src: top.v:9699.8-9699.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2087__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4596_o
	// \src: top.v:4293.14-4293.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4596__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5271_o
	// \src: top.v:1866.15-1866.22
	value<22> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5271__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3245_o
	// \src: top.v:7326.14-7326.21
	value<2> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3245__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3952__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3951__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5113_o
	// \src: top.v:1786.8-1786.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5113__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4356_o
	// \src: top.v:4181.8-4181.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4356__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4346_o
	// \src: top.v:4179.8-4179.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4346__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5091_o
	// \src: top.v:1772.8-1772.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5091__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5083_o
	// \src: top.v:1770.8-1770.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5083__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5268_o
	// \src: top.v:1863.14-1863.21
	value<9> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5268__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst load_word
	// \src: top.v:1763.8-1763.17
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4330_o
	// \src: top.v:4173.8-4173.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4330__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst advance
	// \src: top.v:1760.8-1760.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4323_o
	// \src: top.v:4172.8-4172.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4323__o;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst n5026_o
	// \src: top.v:3690.15-3690.22
	value<11> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5026__o;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst n5030_o
	// \src: top.v:3693.15-3693.22
	value<11> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5030__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6372_o
	// \src: top.v:1259.14-1259.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6372__o_5b_2_3a_0_5d_;
	// \src: top.v:6633.3-6635.37
	value<32> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3444__data_5b_31_3a_0_5d_;
	// \src: top.v:5978.3-5980.35
	value<8> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4955__data_5b_7_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4111_o
	// \src: top.v:4102.8-4102.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4111__o;
	// \src: top.v:5968.3-5970.42
	value<10> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4952__data_5b_9_3a_0_5d_;
	// \src: top.v:5943.3-5945.42
	value<4> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5945_24_1567__ADDR_5b_3_3a_0_5d__24_2023;
	// \src: top.v:5940.3-5942.45
	value<14> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4948__data_5b_13_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4285_o
	// \src: top.v:4158.8-4158.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4285__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4281__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4280__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4279__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4278__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4277__CMP;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4653;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4657;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4669;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4679;
	// \src: top.v:631.3-633.42
	value<16> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6992__data_5b_15_3a_0_5d_;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4687;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4098__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4097__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4096__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4094__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4093__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP;
	// \hdlname: unity_link_inst core_inst response_ring_inst n3404_o
	// \src: top.v:6554.14-6554.21
	value<9> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3404__o;
	// \src: top.v:662.3-664.40
	value<8> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6998__data_5b_7_3a_0_5d_;
	// \src: top.v:659.3-661.37
	value<8> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6996__data_5b_7_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3835_o
	// \src: top.v:3971.8-3971.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3842_o
	// \src: top.v:3972.8-3972.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3842__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3843_o
	// \src: top.v:3973.8-3973.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3843__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3889__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3858_o
	// \src: top.v:3980.8-3980.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3858__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3888__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3887__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3886__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6464_o
	// \src: top.v:1312.8-1312.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6464__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6455_o
	// \src: top.v:1310.8-1310.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6455__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6450_o
	// \src: top.v:1309.8-1309.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6450__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4272_o
	// \src: top.v:4153.8-4153.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4272__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4075__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4398_o
	// \src: top.v:4193.8-4193.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4398__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4076__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4263_o
	// \src: top.v:4150.8-4150.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4263__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6312_o
	// \src: top.v:1224.14-1224.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6312__o_5b_2_3a_0_5d_;
	// \src: top.v:3769.3-3771.37
	value<32> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_5c_n5066__data_5b_31_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3702_o
	// \src: top.v:3884.15-3884.22
	value<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3604__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6305_o
	// \src: top.v:1219.14-1219.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6305__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6298_o
	// \src: top.v:1214.14-1214.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6298__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst tick_inst n6647_o
	// \src: top.v:838.8-838.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6647__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4252_o
	// \src: top.v:4147.14-4147.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4252__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5954_o
	// \src: top.v:2126.13-2126.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5954__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6291_o
	// \src: top.v:1209.14-1209.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6291__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3819__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3818__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6350_o
	// \src: top.v:1244.14-1244.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6350__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6336_o
	// \src: top.v:1242.8-1242.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6336__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6331_o
	// \src: top.v:1238.15-1238.22
	value<13> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6331__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5259_o
	// \src: top.v:1854.15-1854.22
	value<41> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5259__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6284_o
	// \src: top.v:1204.14-1204.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6284__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3630__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3637__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6277_o
	// \src: top.v:1199.14-1199.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6277__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3639__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3643__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3644__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3662__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6270_o
	// \src: top.v:1194.14-1194.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6270__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4229_o
	// \src: top.v:4140.8-4140.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4229__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3676__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3679__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6249_o
	// \src: top.v:1187.13-1187.20
	value<7> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6249__o_5b_6_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4222_o
	// \src: top.v:4135.8-4135.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4222__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4214_o
	// \src: top.v:4133.8-4133.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4214__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6262_o
	// \src: top.v:1189.14-1189.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6262__o;
	// \src: top.v:1143.3-1145.35
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_1145_24_327__EN_5b_9_3a_0_5d__24_378_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4211_o
	// \src: top.v:4132.8-4132.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4211__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6245_o
	// \src: top.v:1185.8-1185.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6245__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst carry_out
	// \src: top.v:3821.8-3821.17
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6199_o
	// \src: top.v:1170.8-1170.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6199__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst advance
	// \src: top.v:1165.8-1165.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_advance;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3339__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst clear_timer
	// \src: top.v:3826.15-3826.26
	value<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4691;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3356__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3363__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3369__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3374__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3378__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3381__CMP;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4695;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4697;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3393__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3394__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3395__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3396__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3405__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3406__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3407__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3408__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4637_o
	// \src: top.v:4312.8-4312.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4637__o;
	// \src: top.v:603.3-605.42
	value<16> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6988__data_5b_15_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3417__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3418__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3419__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3420__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4644_o
	// \src: top.v:4316.8-4316.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4644__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3860_o
	// \src: top.v:3981.8-3981.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3429__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3867_o
	// \src: top.v:3982.8-3982.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3867__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3430__CMP;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4731;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3437__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3873_o
	// \src: top.v:3985.8-3985.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3873__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3438__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3439__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3440__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3441__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3442__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3443__CMP;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4743;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4650_o
	// \src: top.v:4319.8-4319.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4650__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3878_o
	// \src: top.v:3988.8-3988.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3878__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst accepted
	// \src: top.v:3855.8-3855.16
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4435_o
	// \src: top.v:4210.8-4210.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4435__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst advance
	// \src: top.v:11037.8-11037.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_advance;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4376_o
	// \src: top.v:4187.8-4187.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4376__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3179_o
	// \src: top.v:7276.14-7276.21
	value<8> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3179__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n395_o
	// \src: top.v:11055.8-11055.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n395__o;
	// \src: top.v:5988.3-5990.35
	value<32> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4958__data_5b_31_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3174_o
	// \src: top.v:7272.8-7272.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n444_o
	// \src: top.v:11070.14-11070.20
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3170_o
	// \src: top.v:7271.8-7271.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6358_o
	// \src: top.v:1249.14-1249.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6358__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5549_o
	// \src: top.v:1957.14-1957.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5549__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n503_o
	// \src: top.v:11112.14-11112.20
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n503__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n504_o
	// \src: top.v:11113.8-11113.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n504__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5861_o
	// \src: top.v:2084.13-2084.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5861__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3562_o
	// \src: top.v:6167.8-6167.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3562__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3560_o
	// \src: top.v:6166.8-6166.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3560__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n535_o
	// \src: top.v:11142.8-11142.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n535__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n544_o
	// \src: top.v:11144.8-11144.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n544__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n545_o
	// \src: top.v:11145.8-11145.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n545__o;
	// \src: top.v:9090.3-9092.40
	value<32> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2166__data_5b_31_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3541_o
	// \src: top.v:6156.8-6156.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3541__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6379_o
	// \src: top.v:1264.14-1264.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6379__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n559_o
	// \src: top.v:11154.8-11154.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n559__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3523_o
	// \src: top.v:6145.8-6145.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n612_o
	// \src: top.v:11165.8-11165.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n612__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n632_o
	// \src: top.v:11174.8-11174.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n632__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n678_o
	// \src: top.v:11193.8-11193.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n678__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n698_o
	// \src: top.v:11202.8-11202.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n698__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3497_o
	// \src: top.v:6131.8-6131.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3497__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3496_o
	// \src: top.v:6130.8-6130.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3496__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3489_o
	// \src: top.v:6129.8-6129.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3489__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5183_o
	// \src: top.v:1826.8-1826.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5183__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4542_o
	// \src: top.v:4263.8-4263.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4542__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5170_o
	// \src: top.v:1821.8-1821.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5170__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6400_o
	// \src: top.v:1279.14-1279.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6400__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3468_o
	// \src: top.v:6118.8-6118.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3468__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3461_o
	// \src: top.v:6117.8-6117.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3461__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3458_o
	// \src: top.v:6116.8-6116.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3458__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3159_o
	// \src: top.v:7264.14-7264.21
	value<5> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3159__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst grant_sample
	// \src: top.v:6113.8-6113.20
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3157_o
	// \src: top.v:7262.14-7262.21
	value<5> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3157__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3156_o
	// \src: top.v:7261.15-7261.22
	value<31> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3156__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n764_o
	// \src: top.v:11241.15-11241.21
	value<30> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n764__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3154_o
	// \src: top.v:7259.15-7259.22
	value<14> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3154__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n767_o
	// \src: top.v:11244.14-11244.20
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n767__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n775_o
	// \src: top.v:11249.8-11249.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n775__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6187_data
	// \src: top.v:2251.14-2251.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6187__data;
	// \hdlname: unity_link_inst core_inst bus_master_inst sample
	// \src: top.v:6089.11-6089.17
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6185_data
	// \src: top.v:2250.14-2250.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6185__data;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6183_data
	// \src: top.v:2249.14-2249.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6183__data;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5798_o
	// \src: top.v:2058.14-2058.21
	value<6> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5798__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6181_data
	// \src: top.v:2248.14-2248.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6181__data;
	// \hdlname: unity_link_inst core_inst request_decoder_inst letter
	// \src: top.v:9132.8-9132.14
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter;
	// \hdlname: unity_link_inst core_inst request_decoder_inst digit
	// \src: top.v:9133.8-9133.13
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit;
	// \hdlname: unity_link_inst core_inst request_decoder_inst field
	// \src: top.v:9134.14-9134.19
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field;
	// \hdlname: unity_link_inst core_inst request_decoder_inst left
	// \src: top.v:9135.14-9135.18
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst is_due
	// \src: top.v:29.8-29.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst counts
	// \src: top.v:31.8-31.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counts;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3127_o
	// \src: top.v:7232.15-7232.22
	value<14> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3127__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n869_o
	// \src: top.v:11306.15-11306.21
	value<26> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n869__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n872_o
	// \src: top.v:11309.14-11309.20
	value<9> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n872__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n875_o
	// \src: top.v:11311.8-11311.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n875__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5758_o
	// \src: top.v:2037.13-2037.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5758__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n999_o
	// \src: top.v:9158.8-9158.14
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n999__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6719_o
	// \src: top.v:56.8-56.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6719__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3883_o
	// \src: top.v:3991.8-3991.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3883__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1019_o
	// \src: top.v:9167.8-9167.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1019__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5755_o
	// \src: top.v:2034.8-2034.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5755__o;
	// \src: top.v:1142.21-1142.27
	value<10> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_1142_24_374__DATA;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3888_o
	// \src: top.v:3994.8-3994.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3888__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3893_o
	// \src: top.v:3997.8-3997.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3893__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3898_o
	// \src: top.v:4000.8-4000.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3898__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3903_o
	// \src: top.v:4003.8-4003.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3903__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3908_o
	// \src: top.v:4006.8-4006.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3908__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3913_o
	// \src: top.v:4009.8-4009.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3913__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3918_o
	// \src: top.v:4012.8-4012.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3918__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3923_o
	// \src: top.v:4015.8-4015.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3923__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3928_o
	// \src: top.v:4018.8-4018.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3933_o
	// \src: top.v:4021.8-4021.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3933__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3938_o
	// \src: top.v:4024.8-4024.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3938__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3943_o
	// \src: top.v:4028.8-4028.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3943__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3946_o
	// \src: top.v:4031.15-4031.22
	value<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3946__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3950_o
	// \src: top.v:4034.8-4034.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1031_o
	// \src: top.v:9172.8-9172.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5166_o
	// \src: top.v:1818.8-1818.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5166__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6549_o
	// \src: top.v:992.8-992.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6549__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6541_o
	// \src: top.v:987.8-987.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6541__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6534_o
	// \src: top.v:982.8-982.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6534__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6531_o
	// \src: top.v:979.8-979.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6531__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6500_o
	// \src: top.v:971.8-971.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6500__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5727_o
	// \src: top.v:2027.8-2027.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5727__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1054_o
	// \src: top.v:9180.8-9180.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1059_o
	// \src: top.v:9183.14-9183.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1064_o
	// \src: top.v:9184.14-9184.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1067_o
	// \src: top.v:9186.8-9186.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1067__o;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst n6609_o
	// \src: top.v:883.8-883.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6609__o;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst n6607_o
	// \src: top.v:881.8-881.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6607__o;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst n6604_o
	// \src: top.v:879.8-879.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6604__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n245_o
	// \src: top.v:12007.8-12007.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n246_o
	// \src: top.v:12008.8-12008.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n276_o
	// \src: top.v:12015.8-12015.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n276__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n279_o
	// \src: top.v:12018.8-12018.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n279__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n286_o
	// \src: top.v:12023.8-12023.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n286__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n294_o
	// \src: top.v:12028.8-12028.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2719_o
	// \src: top.v:6971.14-6971.21
	value<8> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2719__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1119_o
	// \src: top.v:9204.8-9204.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1119__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1125_o
	// \src: top.v:9207.8-9207.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1125__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1128_o
	// \src: top.v:9208.8-9208.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1128__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1131_o
	// \src: top.v:9209.8-9209.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1131__o;
	// \hdlname: unity_link_inst bus_done
	// \src: top.v:13082.8-13082.16
	value<1> p_unity__link__inst_2e_bus__done;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2715_o
	// \src: top.v:6968.14-6968.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2715__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2714_o
	// \src: top.v:6967.14-6967.21
	value<3> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2714__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2712_o
	// \src: top.v:6965.8-6965.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2712__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1154_o
	// \src: top.v:9222.8-9222.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1154__o;
	// \src: top.v:12178.20-12178.26
	value<9> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_12178_24_3257__DATA;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1157_o
	// \src: top.v:9225.8-9225.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1157__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1166_o
	// \src: top.v:9234.8-9234.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1166__o;
	// \hdlname: unity_link_inst core_inst n198_o
	// \src: top.v:12509.8-12509.14
	value<1> p_unity__link__inst_2e_core__inst_2e_n198__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2699_o
	// \src: top.v:6952.13-6952.20
	value<2> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2699__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2693_o
	// \src: top.v:6946.13-6946.20
	value<3> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2693__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6365_o
	// \src: top.v:1254.14-1254.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6365__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3081_o
	// \src: top.v:7189.14-7189.21
	value<11> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3081__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3071_o
	// \src: top.v:7181.8-7181.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3071__o;
	// \hdlname: unity_link_inst core_inst with_groups_ring_write
	// \src: top.v:12471.8-12471.30
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3062_o
	// \src: top.v:7178.8-7178.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3062__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5160_o
	// \src: top.v:1813.8-1813.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5160__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1249_o
	// \src: top.v:9276.8-9276.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1252_o
	// \src: top.v:9277.8-9277.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1255_o
	// \src: top.v:9278.8-9278.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1258_o
	// \src: top.v:9279.8-9279.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1261_o
	// \src: top.v:9280.8-9280.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1265_o
	// \src: top.v:9281.8-9281.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1268_o
	// \src: top.v:9282.8-9282.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1290_o
	// \src: top.v:9286.8-9286.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1290__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1293_o
	// \src: top.v:9287.8-9287.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1309_o
	// \src: top.v:9292.8-9292.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1309__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1315_o
	// \src: top.v:9294.8-9294.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6386_o
	// \src: top.v:1269.14-1269.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6386__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1339_o
	// \src: top.v:9300.8-9300.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1339__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1345_o
	// \src: top.v:9302.8-9302.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1345__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1348_o
	// \src: top.v:9303.8-9303.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1348__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1351_o
	// \src: top.v:9304.8-9304.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1351__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5565_o
	// \src: top.v:1972.8-1972.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5565__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1367_o
	// \src: top.v:9308.8-9308.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1367__o;
	// \hdlname: unity_link_inst core_inst tx_entry
	// \src: top.v:12383.14-12383.22
	value<10> p_unity__link__inst_2e_core__inst_2e_tx__entry;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3051_o
	// \src: top.v:7169.15-7169.22
	value<14> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3051__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5559_o
	// \src: top.v:1967.8-1967.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5559__o;
	// \hdlname: unity_link_inst core_inst answer_has_id
	// \src: top.v:12367.8-12367.21
	value<1> p_unity__link__inst_2e_core__inst_2e_answer__has__id;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5558_o
	// \src: top.v:1966.14-1966.21
	value<6> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5558__o;
	// \hdlname: unity_link_inst core_inst answer_taken
	// \src: top.v:12362.8-12362.20
	value<1> p_unity__link__inst_2e_core__inst_2e_answer__taken;
	// \hdlname: unity_link_inst core_inst answer_valid
	// \src: top.v:12361.8-12361.20
	value<1> p_unity__link__inst_2e_core__inst_2e_answer__valid;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5557_o
	// \src: top.v:1965.14-1965.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5557__o;
	// \hdlname: unity_link_inst core_inst group_done
	// \src: top.v:12355.8-12355.18
	value<1> p_unity__link__inst_2e_core__inst_2e_group__done;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1404_o
	// \src: top.v:9325.14-9325.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4727_o
	// \src: top.v:4358.8-4358.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4727__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1409_o
	// \src: top.v:9328.8-9328.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o;
	// \hdlname: unity_link_inst core_inst access_done
	// \src: top.v:12344.8-12344.19
	value<1> p_unity__link__inst_2e_core__inst_2e_access__done;
	// \hdlname: unity_link_inst core_inst access_granted
	// \src: top.v:12343.8-12343.22
	value<1> p_unity__link__inst_2e_core__inst_2e_access__granted;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4722_o
	// \src: top.v:4355.8-4355.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4722__o;
	// \hdlname: unity_link_inst core_inst access_more
	// \src: top.v:12339.8-12339.19
	value<1> p_unity__link__inst_2e_core__inst_2e_access__more;
	// \hdlname: unity_link_inst core_inst access_write
	// \src: top.v:12338.8-12338.20
	value<1> p_unity__link__inst_2e_core__inst_2e_access__write;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4716_o
	// \src: top.v:4352.8-4352.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4716__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4710_o
	// \src: top.v:4349.8-4349.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4710__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1413_o
	// \src: top.v:9331.8-9331.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4704_o
	// \src: top.v:4346.8-4346.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4704__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4698_o
	// \src: top.v:4343.8-4343.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4698__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4692_o
	// \src: top.v:4340.8-4340.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4692__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4686_o
	// \src: top.v:4337.8-4337.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4686__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1419_o
	// \src: top.v:9335.8-9335.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1419__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4680_o
	// \src: top.v:4334.8-4334.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4680__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1420_o
	// \src: top.v:9336.8-9336.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4674_o
	// \src: top.v:4331.8-4331.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4674__o;
	// \hdlname: unity_link_inst core_inst hold
	// \src: top.v:12312.8-12312.12
	value<1> p_unity__link__inst_2e_core__inst_2e_hold;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5550_o
	// \src: top.v:1958.8-1958.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5550__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4668_o
	// \src: top.v:4328.8-4328.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4668__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4662_o
	// \src: top.v:4325.8-4325.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4662__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1424_o
	// \src: top.v:9339.8-9339.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o;
	// \hdlname: unity_link_inst core_inst fifo_out_ready
	// \src: top.v:12299.8-12299.22
	value<1> p_unity__link__inst_2e_core__inst_2e_fifo__out__ready;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4656_o
	// \src: top.v:4322.8-4322.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4656__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5548_o
	// \src: top.v:1956.14-1956.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5548__o;
	// \src: top.v:9093.3-9095.41
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_9095_24_2706__EN_5b_31_3a_0_5d__24_2712_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1428_o
	// \src: top.v:9342.8-9342.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n487_o
	// \src: top.v:11100.14-11100.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n487__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5546_o
	// \src: top.v:1954.14-1954.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5546__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5542_o
	// \src: top.v:1953.8-1953.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5542__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n459_o
	// \src: top.v:11080.14-11080.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n459__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1432_o
	// \src: top.v:9345.8-9345.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n452_o
	// \src: top.v:11075.14-11075.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n452__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4347__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n494_o
	// \src: top.v:11105.14-11105.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n494__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4346__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n466_o
	// \src: top.v:11085.14-11085.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n466__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n473_o
	// \src: top.v:11090.14-11090.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n473__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1443_o
	// \src: top.v:9354.8-9354.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1445_o
	// \src: top.v:9355.8-9355.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1446_o
	// \src: top.v:9356.8-9356.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5521_o
	// \src: top.v:1946.8-1946.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5521__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n480_o
	// \src: top.v:11095.14-11095.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n480__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5516_o
	// \src: top.v:1944.8-1944.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5516__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4229__CMP;
	// \src: top.v:12179.3-12181.35
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_12181_24_3210__EN_5b_8_3a_0_5d__24_3261_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2559_o
	// \src: top.v:6869.14-6869.21
	value<3> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2559__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5509_o
	// \src: top.v:1942.8-1942.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5509__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2583_o
	// \src: top.v:6879.14-6879.21
	value<2> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2583__o_5b_1_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5507_o
	// \src: top.v:1941.14-1941.21
	value<5> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5507__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2588_o
	// \src: top.v:6883.8-6883.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2588__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2654_o
	// \src: top.v:6920.14-6920.21
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2654__o_5b_0_5d_;
	// \src: top.v:6636.3-6638.37
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_6638_24_2226__EN_5b_31_3a_0_5d__24_2252_5b_0_5d_;
	// \src: top.v:634.3-636.44
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_counters_24_top_2e_v_3a_636_24_34__EN_5b_15_3a_0_5d__24_175_5b_0_5d_;
	// \src: top.v:665.3-667.40
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_losses_24_top_2e_v_3a_667_24_51__EN_5b_7_3a_0_5d__24_186_5b_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4228__CMP;
	// \src: top.v:5991.3-5993.41
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_last_24_top_2e_v_3a_5993_24_1586__EN_5b_31_3a_0_5d__24_2052_5b_0_5d_;
	// \src: top.v:5981.3-5983.37
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_list_24_top_2e_v_3a_5983_24_1585__EN_5b_7_3a_0_5d__24_2043_5b_0_5d_;
	// \src: top.v:5971.3-5973.41
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_state__memory_24_top_2e_v_3a_5973_24_1584__EN_5b_9_3a_0_5d__24_2034_5b_0_5d_;
	// \src: top.v:5943.3-5945.42
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5945_24_1567__EN_5b_13_3a_0_5d__24_2025_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5494_o
	// \src: top.v:1937.8-1937.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5494__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1478_o
	// \src: top.v:9382.15-9382.22
	value<11> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1478__o;
	// \src: top.v:3772.3-3774.37
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_3774_24_1521__EN_5b_31_3a_0_5d__24_1547_5b_0_5d_;
	// \src: top.v:11429.19-11429.34
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$xor$top.v:11429$3078
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o = xor_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<25,18>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<7,0>().val());
	// \src: top.v:1379.20-1379.66
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1379$391
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6245__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<4,3>().val(), value<1>{0x1u});
	// \src: top.v:7905.20-7905.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7905$2427
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<4>{0xcu});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11439$3080 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4566
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n452__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o.slice<7>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4325 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4326_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1377$390
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6249__o_5b_6_3a_0_5d_ = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6245__o.concat(logic_not<1>(value<29>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<4,3>()).val())).val(), value<1>{0x1u}) ? value<7>{0x5au} : value<7>{0x30u});
	// \src: top.v:7915.20-7915.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7915$2430
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<4>{0xfu});
	// \src: top.v:9852.20-9852.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9852$2748
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1067__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<11,8>().val());
	// \src: top.v:1392.20-1392.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$xor$top.v:1392$393
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6262__o = xor_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<12,5>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6249__o_5b_6_3a_0_5d_);
	// \src: top.v:1500.20-1500.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$xor$top.v:1500$417
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6350__o = xor_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<12,5>().val(), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<87,80>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9846$2746 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9844$2745 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:9842$2744 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9838$2742
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3>().val() ? (or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<2>().val()), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o) ? value<4>{0x5u} : value<4>{0xau}) : value<4>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11449$3082 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4568
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n459__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o.slice<6>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n452__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n452__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9848$2747 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:9826$2738
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<5>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o) ? value<4>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o);
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1402$395 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4598
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6270__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6262__o.slice<7>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6262__o.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6262__o.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1510$419 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4614
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6358__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6350__o.slice<7>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6350__o.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6350__o.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:9854.20-9854.47
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9854$2749
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1067__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<11,8>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:11615$3122 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11613$3121 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11611$3120
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n632__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<15,12>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<15,12>().val(), value<3>{0x6u}));
	// \src: top.v:11597.19-11597.36
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11597$3115
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n612__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<15,12>().val(), value<2>{0x3u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11459$3084 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4570
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n466__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o.slice<5>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n459__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n459__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:7824.20-7824.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7824$2391
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1701__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<3>{0x7u});
	// \src: top.v:7822.20-7822.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7822$2390
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1698__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<3>{0x4u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4675$1601 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:4673$1600
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o = and_uu<16>(or_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__trigger.curr), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9779$2725 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9777$2724 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9775$2723 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ge$top.v:9769$2721 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$le$top.v:9773$2722 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9765$2720 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9763$2719 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9759$2718 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9755$2717
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter = and_uu<1>(and_uu<1>(and_uu<1>((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1067__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<52>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<53>().val())), (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x1au}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<3>{0x7u})) ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1412$397 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4600
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6277__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6262__o.slice<6>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6270__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6270__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1520$421 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4616
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6365__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6350__o.slice<6>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6358__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6358__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:10841.20-10841.41
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10841$3011
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1948__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<16>().val() ? value<1>{0u} : value<1>{0x1u});
	// \src: top.v:7826.20-7826.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7826$2392
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1698__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1701__o);
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11469$3086 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4572
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n473__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o.slice<4>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n466__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n466__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:10901.20-10901.37
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10901$3032
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2006__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1948__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o);
	// \src: top.v:10578.20-10578.43
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10578$2923
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<113,105>().val());
	// \src: top.v:7811.20-7811.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7811$2385
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1530__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val());
	// \src: top.v:7788.20-7788.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7788$2374
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1526__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<2>{0x2u});
	// \src: top.v:7786.20-7786.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7786$2373
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1524__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<1>{0x1u});
	// \src: top.v:7474.20-7474.38
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7474$2264
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2229__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19,16>().val(), value<2>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:11675$3139 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11673$3138 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11671$3137
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n698__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<7,4>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<7,4>().val(), value<3>{0x6u}));
	// \src: top.v:11657.19-11657.36
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11657$3132
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n678__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<7,4>().val(), value<2>{0x3u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1422$399 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4602
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6284__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6262__o.slice<5>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6277__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6277__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1530$423 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4618
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6372__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6350__o.slice<5>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6365__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6365__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:7813.20-7813.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7813$2386
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1803__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<2>{0x3u});
	// \src: top.v:10843.20-10843.41
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10843$3012
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1954__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<16>().val() ? value<1>{0u} : value<1>{0u});
	// \src: top.v:10256.20-10256.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10256$2847
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<4>{0x9u});
	// \src: top.v:10220.20-10220.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10220$2839
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1419__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<4>{0x8u});
	// \src: top.v:7790.20-7790.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7790$2375
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1524__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1526__o);
	// \src: top.v:7462.20-7462.38
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7462$2260
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2214__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19,16>().val(), value<3>{0x5u});
	// \src: top.v:7580.20-7580.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7580$2304
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val(), value<3>{0x6u});
	// \src: top.v:7576.20-7576.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7576$2303
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val(), value<3>{0x4u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7522$2283 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:7520$2282
	p_unity__link__inst_2e_core__inst_2e_hold = (reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val()) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11479$3088 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4574
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n480__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o.slice<3>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n473__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n473__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10865$3019 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10861$3018 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10855$3016
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1973__o = or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1067__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<114>().val()), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<113>().val());
	// \src: top.v:10461.20-10461.37
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10461$2895
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1419__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o);
	// \src: top.v:10254.20-10254.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10254$2846
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x4u});
	// \src: top.v:10240.20-10240.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10240$2843
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x7u});
	// \src: top.v:10234.20-10234.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10234$2842
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x6u});
	// \src: top.v:10228.20-10228.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10228$2841
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x5u});
	// \src: top.v:10212.20-10212.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10212$2837
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<2>{0x2u});
	// \src: top.v:10206.20-10206.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10206$2836
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<1>{0x1u});
	// \src: top.v:7841.20-7841.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7841$2399
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<4>{0x8u});
	// \src: top.v:2370.20-2370.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2370$745
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5160__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<2,0>().val(), value<2>{0x3u});
	// \src: top.v:2356.20-2356.40
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2356$740
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5144__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<77,72>().val());
	// \src: top.v:7856.20-7856.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7856$2406
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1853__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<4>{0xau});
	// \src: top.v:7849.20-7849.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7849$2403
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1851__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<4>{0x9u});
	// \src: top.v:7782.20-7782.54
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7782$2371
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2562__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<133>().val() ? value<1>{0u} : value<1>{0x1u});
	// \src: top.v:7466.20-7466.38
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7466$2261
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2217__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19,16>().val(), value<3>{0x6u});
	// \src: top.v:9954.20-9954.28
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9954$2785
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1166__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<125>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1432$401 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4604
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6291__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6262__o.slice<4>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6284__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6284__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1540$425 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4620
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6379__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6350__o.slice<4>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6372__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6372__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:7830.20-7830.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7830$2394
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1794__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<3>{0x5u});
	// \src: top.v:10689.20-10689.64
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ge$top.v:10689$2961
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1807__o = ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,41>().val(), value<5>{0x10u});
	// \src: top.v:9898.20-9898.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9898$2766
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1131__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o, value<3>{0x7u});
	// \src: top.v:9896.20-9896.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9896$2765
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1128__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o, value<3>{0x4u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:9894$2764 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9892$2763 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9890$2762
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1125__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o, value<2>{0x2u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o, value<4>{0x9u}));
	// \src: top.v:9888.20-9888.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9888$2761
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1119__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o, value<1>{0x1u});
	// \src: top.v:2352.20-2352.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2352$739
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5141__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<2,0>().val(), value<3>{0x5u});
	// \src: top.v:2380.20-2380.28
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2380$748
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5166__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<10>().val());
	// \src: top.v:7832.20-7832.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7832$2395
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1797__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<3>{0x6u});
	// \src: top.v:1349.20-1349.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1349$384
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6199__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<2,0>().val(), value<1>{0x1u});
	// \src: top.v:4849.20-4849.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4849$1656
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9936$2778 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9934$2777 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:9926$2774 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9924$2773 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9922$2772 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:9920$2771 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9918$2770
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1157__o = not_u<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_hold, or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<55>().val(), and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter), (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u})))));
	// \src: top.v:9930.20-9930.28
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9930$2775
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1154__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<126>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11489$3090 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4576
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n487__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n480__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n480__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:10847.20-10847.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10847$3014
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1962__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<4>{0xau});
	// \src: top.v:10258.20-10258.37
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10258$2848
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10222$2840 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10218$2838
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<2>{0x3u}), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1419__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3323 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3324_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3325_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3326_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3327_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3328_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3329_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3330_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10417$2873 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10437$2883 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10433$2881 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10429$2879 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10435$2882 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10431$2880 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10449$2889
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<1>{0x1u}) ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o ? value<4>{0xau} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<2>{0x2u}) ? ((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1530__o ? value<1>{0u} : value<1>{0x1u})) ? value<4>{0x4u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o ? value<4>{0x3u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1530__o ? value<4>{0xau} : value<4>{0u}))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<3>{0x4u}) ? value<4>{0x4u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<4>{0x8u}) ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o ? value<4>{0x6u} : value<4>{0xau}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<5>{0x10u}) ? value<4>{0x7u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<6>{0x20u}) ? value<4>{0x8u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<7>{0x40u}) ? value<4>{0x9u} : value<4>{0xau})))))));
	// \src: top.v:5136.20-5136.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5136$1756
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4214__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr, value<3>{0x6u});
	// \src: top.v:2396.20-2396.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2396$754
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5183__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<2,0>().val(), value<3>{0x4u});
	// \src: top.v:2386.20-2386.43
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:2386$750
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5170__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<39,31>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7898$2425 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7896$2424 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7894$2423
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o = or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1851__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1853__o), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<4>{0xbu}));
	// \src: top.v:7834.20-7834.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7834$2396
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1794__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1797__o);
	// \src: top.v:7815.20-7815.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7815$2387
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1530__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1803__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7807$2383 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7803$2381 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7797$2378
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2588__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2562__o, logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.curr)), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2562__o);
	// \src: top.v:7780.20-7780.60
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7780$2370
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2559__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<133>().val() ? value<3>{0x6u} : value<3>{0u});
	// \src: top.v:7556.20-7556.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7556$2296
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val(), value<3>{0x7u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$or$top.v:1345$383 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$not$top.v:1343$382
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_advance = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<25>().val()), p_unity__link__inst_2e_core__inst_2e_sent__ready.curr);
	// \src: top.v:4851.20-4851.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4851$1657
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3842__o = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1442$403 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4606
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6298__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6262__o.slice<3>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6291__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6291__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1550$427 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4622
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6386__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6350__o.slice<3>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6379__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6379__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:10636.20-10636.42
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10636$2940
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1760__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<40,33>().val());
	// \full_case: 1
	// \src: top.v:10367.19-10367.19|top.v:10367.5-10376.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3339_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3339__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<7>{0x40u});
	// \src: top.v:10076.20-10076.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10076$2809
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<4>{0xdu});
	// \src: top.v:10041.20-10041.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10041$2802
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x11u});
	// \src: top.v:10099.20-10099.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10099$2815
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x13u});
	// \src: top.v:10043.20-10043.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10043$2803
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<4>{0xbu});
	// \src: top.v:10132.20-10132.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10132$2824
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1351__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x10u});
	// \src: top.v:10130.20-10130.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10130$2823
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1348__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x18u});
	// \src: top.v:10128.20-10128.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10128$2822
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1345__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<4>{0xeu});
	// \src: top.v:10047.20-10047.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10047$2805
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<3>{0x7u});
	// \src: top.v:10045.20-10045.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10045$2804
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<4>{0x9u});
	// \src: top.v:10039.20-10039.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10039$2801
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<4>{0x8u});
	// \src: top.v:10037.20-10037.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10037$2800
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x17u});
	// \src: top.v:10035.20-10035.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10035$2799
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x12u});
	// \src: top.v:6249.20-6249.34
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:6249$2129
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3461__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.curr);
	// \src: top.v:5138.20-5138.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5138$1757
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4214__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:7924.38-7924.38|top.v:7920.5-7930.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3799_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3679__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<4>{0x8u});
	// \src: top.v:8426.20-8426.47
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8426$2578
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3028__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<133>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<13,3>().concat(value<3>{0x7u}).val() : value<3>{0x4u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<24,17>()).concat(value<3>{0x6u}).val());
	// \full_case: 1
	// \src: top.v:7923.38-7923.38|top.v:7920.5-7930.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3800_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3637__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:7927.38-7927.38|top.v:7920.5-7930.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3796_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3676__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:7922.38-7922.38|top.v:7920.5-7930.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3801_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3630__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:7926.38-7926.38|top.v:7920.5-7930.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3797_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3643__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<2>{0x2u});
	// \src: top.v:7876.20-7876.47
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7876$2415
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2654__o_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_group__is__set.curr ? value<1>{0u} : value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:7925.38-7925.38|top.v:7920.5-7930.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3798_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3644__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<3>{0x4u});
	// \src: top.v:7799.20-7799.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7799$2379
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2583__o_5b_1_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2588__o ? value<2>{0x1u} : value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:7920.19-7920.19|top.v:7920.5-7930.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3802_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3639__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<8>{0x80u});
	// \full_case: 1
	// \src: top.v:8467.38-8467.38|top.v:8466.5-8476.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3662_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3662__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<7>{0x40u});
	// \src: top.v:2520.20-2520.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2520$789
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5337__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<6,3>().val(), value<3>{0x5u});
	// \src: top.v:7558.20-7558.41
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7558$2297
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2326__o = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:2284.20-2284.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2284$718
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5083__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<2,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4853$1658 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4847$1655 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:4845$1654 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4843$1653 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7584$2306 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7582$2305
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3843__o = and_uu<1>(and_uu<1>((or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o) ? value<1>{0x1u} : value<1>{0u}), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4931__q.curr, not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4928__q.curr))), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3842__o);
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11755$3159 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:11749$3157 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:11753$3158
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n775__o = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<45>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<44>().val()));
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11499$3092 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4578
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n494__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n452__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n487__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n487__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9914$2769 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3456 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3457_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3458_CMP0
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1067__o ? value<1>{0u}.concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1131__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1128__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1125__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1119__o).val(), value<3>{0x4u}) ? value<3>{0x7u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1131__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1128__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1125__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1119__o).val(), value<4>{0x8u}) ? value<3>{0x3u} : value<3>{0x1u}))).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<15,12>().val());
	// \src: top.v:10490.20-10490.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10490$2902
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1624__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o, value<3>{0x7u});
	// \src: top.v:10488.20-10488.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10488$2901
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1621__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o, value<3>{0x4u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10486$2900 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10484$2899 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10482$2898
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1618__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o, value<2>{0x2u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o, value<4>{0x9u}));
	// \src: top.v:10480.20-10480.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10480$2897
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1612__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o, value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10089.19-10089.19|top.v:10089.5-10093.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3430_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3430__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10090.33-10090.33|top.v:10089.5-10093.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3429_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3429__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10116.19-10116.19|top.v:10116.5-10122.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3420_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3420__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10117.35-10117.35|top.v:10116.5-10122.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3419_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3419__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10118.35-10118.35|top.v:10116.5-10122.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3418_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3418__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10119.35-10119.35|top.v:10116.5-10122.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3417_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3417__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10145.19-10145.19|top.v:10145.5-10151.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3408_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3408__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1351__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10146.35-10146.35|top.v:10145.5-10151.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3407_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3407__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1351__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10147.35-10147.35|top.v:10145.5-10151.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3406_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3406__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1351__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10148.35-10148.35|top.v:10145.5-10151.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3405_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3405__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1351__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10069.38-10069.38|top.v:10063.5-10072.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3437_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3437__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10056.34-10056.34|top.v:10051.5-10060.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3447_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3438__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10055.34-10055.34|top.v:10051.5-10060.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3448_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3439__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10054.34-10054.34|top.v:10051.5-10060.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3449_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3440__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10053.34-10053.34|top.v:10051.5-10060.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3450_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3441__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:10052.34-10052.34|top.v:10051.5-10060.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3451_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3442__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:10051.19-10051.19|top.v:10051.5-10060.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3452_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3443__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<7>{0x40u});
	// \src: top.v:6251.20-6251.41
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6251$2130
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3468__o = (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3461__o ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6247$2128 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6255$2132
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3458__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample, not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr));
	// \src: top.v:5170.20-5170.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5170$1772
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4263__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr, value<3>{0x5u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7452$2258 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7448$2256
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19,16>().val(), value<2>{0x3u}) ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:8557.20-8557.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8557$2598
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3071__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1526__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1803__o);
	// \src: top.v:8551.20-8551.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8551$2595
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3062__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1530__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1524__o);
	// \src: top.v:2524.20-2524.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2524$791
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5340__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<6,3>().val(), value<3>{0x6u});
	// \src: top.v:2512.20-2512.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2512$785
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5325__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<6,3>().val(), value<2>{0x2u});
	// \src: top.v:2508.20-2508.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2508$783
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5322__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<6,3>().val(), value<1>{0x1u});
	// \src: top.v:2657.20-2657.43
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2657$835
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5542__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<39,31>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7596$2308 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:7594$2307
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2372__o = (reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<73,70>().val()) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7608$2312 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7606$2311
	p_unity__link__inst_2e_core__inst_2e_answer__valid = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2326__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<22>().val()));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2280$717 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$and$top.v:1353$386 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1351$385 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2278$716
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<88>().val()), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_advance, (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6199__o ? value<1>{0x1u} : value<1>{0u})));
	// \full_case: 1
	// \src: top.v:707.32-707.32|top.v:704.5-709.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4384_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<1,0>().val(), value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:706.32-706.32|top.v:704.5-709.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4385_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<1,0>().val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:705.32-705.32|top.v:704.5-709.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4386_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4346__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<1,0>().val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:704.19-704.19|top.v:704.5-709.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4387_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4347__CMP = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<1,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:11372$3070 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9960$2788 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9958$2787 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9956$2786 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9950$2784 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9948$2783 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:11370$3069
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_advance = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<54>().val()), and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1154__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1157__o), not_u<1>(and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<55>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<56>().val()), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1166__o))));
	// \src: top.v:11555.19-11555.35
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:11555$3103
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n535__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<39>().val(), p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<8>().val());
	// \src: top.v:11873.19-11873.45
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11873$3182
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n875__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<37,26>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1452$405 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4608
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6305__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6262__o.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6298__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6298__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1560$429 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4624
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6393__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6350__o.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6386__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6386__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10685$2960 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10681$2958 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10677$2956 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10673$2954
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1804__o = or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1698__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1794__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1797__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1701__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1803__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10200$2835 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$add$top.v:10196$2834
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<52>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<49,46>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<49,46>().val());
	// \src: top.v:10391.20-10391.35
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10391$2863
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1482__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left);
	// \src: top.v:10516.20-10516.42
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$add$top.v:10516$2908
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1643__o = add_uu<9>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<113,105>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10387$2861 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10382$2860 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3338
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1478__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o) ? value<11>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<115>().concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3339__CMP ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<114>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<113,105>()).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:9809$2735 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9807$2734 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9805$2733
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1019__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<53,50>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<53,50>().val(), value<3>{0x6u}));
	// \src: top.v:9791.19-9791.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9791$2728
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n999__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<53,50>().val(), value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:10282.37-10282.37|top.v:10276.5-10285.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3381_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3381__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10294.37-10294.37|top.v:10289.5-10298.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3378_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3378__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10306.37-10306.37|top.v:10302.5-10311.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3374_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3374__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10318.37-10318.37|top.v:10315.5-10324.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3369_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3369__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10330.37-10330.37|top.v:10328.5-10337.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3363_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3363__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:10342.37-10342.37|top.v:10341.5-10350.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3356_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3356__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<6>{0x20u});
	// \src: top.v:10153.20-10153.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10153$2827
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1367__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<4,0>().val(), value<5>{0x11u});
	// \src: top.v:10124.20-10124.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10124$2820
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1339__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<4,0>().val(), value<3>{0x4u});
	// \src: top.v:10095.20-10095.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10095$2813
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1309__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<4,0>().val());
	// \src: top.v:10074.20-10074.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10074$2808
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1290__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<4,0>().val(), value<5>{0x10u});
	// \src: top.v:5150.20-5150.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5150$1762
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4229__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4919__q.curr, value<2>{0x2u});
	// \src: top.v:6253.20-6253.37
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6253$2131
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3458__o, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3468__o);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5134$1755 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5132$1754 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5130$1753
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4211__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4922__q.curr.slice<1>().val(), (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4919__q.curr, value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u}));
	// \src: top.v:6273.20-6273.34
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:6273$2141
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3489__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.curr, value<2>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7494$2271 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7492$2270
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2254__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked, not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<57>().val()));
	// \full_case: 1
	// \src: top.v:8611.33-8611.33|top.v:8609.5-8614.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3604_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3604__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1701__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3071__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3062__o).val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8535$2588 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3675 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3672 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3661
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3051__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<133>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<13,3>().concat(value<3>{0x7u}).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3662__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<42,41>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3639__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3028__o.slice<13,12>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<13,12>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3639__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3028__o.slice<11,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<11,3>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3676__CMP ? value<3>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3643__CMP ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2583__o_5b_1_3a_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3644__CMP ? value<3>{0x3u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3679__CMP ? value<3>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3637__CMP ? value<3>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3630__CMP ? value<2>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2654__o_5b_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3639__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3028__o.slice<2,0>().val() : value<3>{0x7u})))))))).val());
	// \src: top.v:8035.20-8035.41
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$add$top.v:8035$2443
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2719__o = add_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<10,3>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8027$2441 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3636 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7879$2416 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7874$2414 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7870$2412
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2714__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<133>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<60,58>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3637__CMP ? value<3>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3630__CMP ? (p_unity__link__inst_2e_core__inst_2e_group__is__set.curr ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1851__o ? value<3>{0x1u} : value<2>{0x1u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1853__o ? value<1>{0u} : value<1>{0x1u})).val()) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<60,58>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3639__CMP ? value<3>{0x4u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<60,58>().val()))));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8024$2440 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3642 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7801$2380
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2712__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<133>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<56>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3643__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2588__o ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3644__CMP ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<56>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8029$2442 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3629 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7847$2402 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7888$2420 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7881$2417 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7843$2400
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2715__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<133>().val() ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2559__o_5b_2_3a_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3630__CMP ? (and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2562__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_group__is__set.curr)), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2562__o) ? value<4>{0x6u} : value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2559__o_5b_2_3a_0_5d_).val()) : value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2559__o_5b_2_3a_0_5d_).val()));
	// \src: top.v:2616.20-2616.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2616$827
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5494__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<6,3>().val(), value<4>{0xbu});
	// \src: top.v:2612.20-2612.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2612$825
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5485__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<6,3>().val(), value<4>{0xau});
	// \src: top.v:2608.20-2608.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2608$823
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5476__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<6,3>().val(), value<4>{0x9u});
	// \src: top.v:2604.20-2604.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2604$821
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5467__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<6,3>().val(), value<4>{0x8u});
	// \src: top.v:2596.20-2596.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2596$817
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5449__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5325__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5340__o);
	// \src: top.v:2588.20-2588.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2588$813
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5437__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5322__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5337__o);
	// \src: top.v:2532.20-2532.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2532$795
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5346__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<6,3>().val(), value<2>{0x3u});
	// \src: top.v:2667.20-2667.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2667$840
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5550__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5542__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5166__o);
	// \src: top.v:7626.20-7626.28
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7626$2314
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2398__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2372__o);
	// \src: top.v:2659.20-2659.45
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2659$836
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5546__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5542__o ? value<3>{0u} : value<3>{0x5u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2288$720 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2286$719
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5091__o = and_uu<1>((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5083__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance);
	// \full_case: 1
	// \src: top.v:747.32-747.32|top.v:744.5-749.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4364_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4339__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<3,2>().val(), value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:746.32-746.32|top.v:744.5-749.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4365_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4340__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<3,2>().val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:745.32-745.32|top.v:744.5-749.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4366_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4341__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<3,2>().val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:744.19-744.19|top.v:744.5-749.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4367_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4342__CMP = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<3,2>().val());
	// \src: top.v:11559.19-11559.41
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11559$3105
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n544__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<7,0>().val(), value<4>{0xdu});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10785$2994 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10781$2992
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1901__o = or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1698__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1701__o);
	// \full_case: 1
	// \src: top.v:10166.19-10166.19|top.v:10166.5-10172.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3396_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3396__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1367__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1339__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1309__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1290__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10167.34-10167.34|top.v:10166.5-10172.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3395_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3395__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1367__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1339__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1309__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1290__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10168.34-10168.34|top.v:10166.5-10172.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3394_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3394__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1367__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1339__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1309__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1290__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10169.34-10169.34|top.v:10166.5-10172.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3393_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3393__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1367__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1339__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1309__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1290__o).val(), value<1>{0x1u});
	// \src: top.v:6275.20-6275.41
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6275$2142
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3496__o = (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3489__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:8577.33-8577.33|top.v:8575.5-8580.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3617
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3081__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3604__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3051__o.slice<13,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<13,3>().val());
	// \full_case: 1
	// \src: top.v:8210.38-8210.38|top.v:8209.5-8219.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3721
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2699__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3662__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<42,41>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3639__CMP ? value<2>{0x2u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<13,12>().val()));
	// \full_case: 1
	// \src: top.v:7927.38-7927.38|top.v:7920.5-7930.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3795
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2693__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3676__CMP ? value<3>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3643__CMP ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2583__o_5b_1_3a_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3644__CMP ? value<3>{0x3u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3679__CMP ? value<3>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3637__CMP ? value<3>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3630__CMP ? value<2>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2654__o_5b_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3639__CMP ? value<3>{0x6u} : value<3>{0x7u})))))));
	// \src: top.v:2665.20-2665.51
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2665$839
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5549__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<10>().val() ? value<3>{0x1u} : value<3>{0x7u});
	// \src: top.v:2827.20-2827.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2827$898
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5755__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<2,0>().val(), value<3>{0x6u});
	// \src: top.v:2663.20-2663.46
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2663$838
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5548__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<10>().val() ? value<3>{0x4u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5546__o);
	// \src: top.v:5378.20-5378.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5378$1854
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4542__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<60,58>().val(), value<2>{0x2u});
	// \src: top.v:5290.20-5290.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5290$1819
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4435__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<60,58>().val(), value<3>{0x4u});
	// \src: top.v:12078.19-12078.38
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12078$3211
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o = and_uu<1>(p_in__valid, p_in__ready.curr);
	// cells $flatten\unity_link_inst.\core_inst.\rx_register_inst.$or$top.v:11966$3201 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11378$3072 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:11376$3071 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$not$top.v:11968$3202
	p_unity__link__inst_2e_core__inst_2e_fifo__out__ready = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_character__valid.curr), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_advance, not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<41>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11575$3109 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:11569$3107 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11573$3108
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n559__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<37,26>().val(), value<12>{0x800u}), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n535__o));
	// \src: top.v:11514.19-11514.39
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11514$3096
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n504__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<16>().val() ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11512$3095 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11509$3094 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4580
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n503__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<16>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n466__o_5b_2_3a_0_5d_.slice<2>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n473__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n480__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n487__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n494__o_5b_2_3a_0_5d_.slice<2>()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n459__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n494__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n494__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val())).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<25,18>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1462$407 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4610
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6312__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6270__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6305__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6305__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1570$431 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4626
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6400__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6358__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6393__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6393__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10598$2930 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10586$2926 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10580$2924 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10574$2922 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10570$2921 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10584$2925
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1703__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o, and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<6>().val()), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<114>().val(), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<11,8>().val(), value<3>{0x4u})))));
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3460 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3461_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3462_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9789$2727 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$le$top.v:9787$2726 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9803$2732 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9801$2731 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ge$top.v:9795$2729 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$le$top.v:9799$2730
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1019__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n999__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<49,46>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1019__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n999__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<49,46>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<49,46>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u}));
	// \src: top.v:10566.20-10566.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10566$2920
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1682__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1166__o, p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<56>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5186$1779 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5182$1778 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5180$1777 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5178$1776
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4285__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample, (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr) ? value<1>{0x1u} : value<1>{0u})), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4922__q.curr.slice<3>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5176$1775 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5174$1774 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5172$1773
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4272__o = and_uu<1>(and_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4263__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4211__o), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room.curr);
	// \src: top.v:6277.20-6277.40
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6277$2143
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3497__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3496__o, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr);
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2414$761 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2412$760 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2410$759 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2408$758 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2402$756 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2392$753 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2390$752 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2388$751 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2382$749 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2376$747 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2366$744 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2364$743 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2358$741 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:2362$742
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance, or_uu<1>(or_uu<1>((and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<39,31>().val(), value<1>{0x1u}), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5144__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5141__o)) ? value<1>{0x1u} : value<1>{0u}), (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5170__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5166__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5144__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5160__o))) ? value<1>{0x1u} : value<1>{0u})), (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5170__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5144__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5183__o)) ? value<1>{0x1u} : value<1>{0u})));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7498$2273 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7496$2272 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7488$2269 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7486$2268
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word = and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<46,39>().val(), value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u}), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2254__o));
	// \src: top.v:5453.20-5453.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5453$1886
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3562__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_access__failure.curr);
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7482$2267 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7480$2266
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2229__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2217__o) ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:7458.20-7458.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7458$2259
	p_unity__link__inst_2e_core__inst_2e_access__write = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<18>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<57>().val());
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6285$2147 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6283$2146
	p_unity__link__inst_2e_core__inst_2e_access__done = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3496__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr));
	// \src: top.v:1042.20-1042.39
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1042$328
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6500__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<25>().val(), p_unity__link__inst_2e_core__inst_2e_sent__ready.curr);
	// \src: top.v:2643.20-2643.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2643$833
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5521__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<7,3>().val(), value<4>{0xeu});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2514$786 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2510$784 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2506$782
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5326__o = or_uu<1>(or_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<6,3>().val()), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5322__o), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5325__o);
	// \src: top.v:2550.20-2550.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2550$804
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5383__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<6,3>().val(), value<4>{0xfu});
	// \src: top.v:2546.20-2546.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2546$802
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5374__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<6,3>().val(), value<4>{0xeu});
	// \src: top.v:2542.20-2542.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2542$800
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5365__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<6,3>().val(), value<4>{0xdu});
	// \src: top.v:2538.20-2538.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2538$798
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5356__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<6,3>().val(), value<4>{0xcu});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2534$796 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2530$794 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2528$793 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2526$792 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2522$790 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2518$788
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5347__o = or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<6,3>().val(), value<3>{0x4u}), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5337__o), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5340__o), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<6,3>().val(), value<3>{0x7u})), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5346__o);
	// \src: top.v:2487.20-2487.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2487$777
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5297__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<7,3>().val(), value<5>{0x11u});
	// \src: top.v:2485.20-2485.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2485$776
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5293__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<7,3>().val(), value<5>{0x10u});
	// memory \unity_link_inst.core_inst.frame_writer_inst.n6186 read port 0
	auto tmp_0 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<77,72>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_0.valid && "out of bounds read");
	if(tmp_0.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6187__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6186[tmp_0.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6187__data = value<4> {};
	}
	// \full_case: 1
	// \src: top.v:3116.36-3116.36|top.v:3115.5-3120.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4228_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4228__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5755__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5183__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5160__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:3115.19-3115.19|top.v:3115.5-3120.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4229_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4229__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5755__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5183__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5160__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:3117.33-3117.33|top.v:3115.5-3120.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4227_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4227__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5755__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5183__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5160__o).val(), value<1>{0x1u});
	// memory \unity_link_inst.core_inst.frame_writer_inst.n6184 read port 0
	auto tmp_1 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<77,72>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_1.valid && "out of bounds read");
	if(tmp_1.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6185__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6184[tmp_1.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6185__data = value<4> {};
	}
	// memory \unity_link_inst.core_inst.frame_writer_inst.n6182 read port 0
	auto tmp_2 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<77,72>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_2.valid && "out of bounds read");
	if(tmp_2.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6183__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6182[tmp_2.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6183__data = value<4> {};
	}
	// memory \unity_link_inst.core_inst.frame_writer_inst.n6180 read port 0
	auto tmp_3 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<77,72>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_3.valid && "out of bounds read");
	if(tmp_3.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6181__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6180[tmp_3.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6181__data = value<4> {};
	}
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2316$731 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2314$730 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2312$729 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2308$728
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5113__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5091__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available.curr), not_u<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<78>().val(), p_unity__link__inst_2e_core__inst_2e_answer__valid)));
	// \src: top.v:2694.20-2694.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2694$853
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5565__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<2,0>().val(), value<1>{0x1u});
	// \src: top.v:2813.20-2813.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2813$895
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5727__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<2,0>().val(), value<2>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4867$1665 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4861$1662 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4859$1661 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:325$64 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:323$63 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:321$62 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4857$1660 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4855$1659
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3858__o = and_uu<1>(and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4928__q.curr, not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3843__o)), not_u<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr, (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr) ? value<1>{0x1u} : value<1>{0u})))), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3842__o);
	// \src: top.v:5447.20-5447.40
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5447$1883
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4596__o = add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4936__q.curr, value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:5389.19-5389.19|top.v:5389.5-5393.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4076_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4076__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4542__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4435__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:5390.32-5390.32|top.v:5389.5-5393.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4075_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4075__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4542__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4435__o).val(), value<1>{0x1u});
	// \src: top.v:5232.20-5232.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5232$1793
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4356__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr, value<4>{0x8u});
	// \src: top.v:12080.19-12080.40
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12080$3212
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr, p_unity__link__inst_2e_core__inst_2e_fifo__out__ready);
	// \src: top.v:12094.19-12094.40
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$eq$top.v:12094$3219
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n276__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11745$3156 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11737$3154 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11719$3150 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11717$3149 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11715$3148 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11699$3145 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11685$3141 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11645$3129 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11639$3128 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11625$3124 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3297 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3298_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3299_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11595$3114 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:11593$3113 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11609$3119 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11607$3118 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ge$top.v:11601$3116 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:11605$3117 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11637$3127 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11635$3126 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$add$top.v:11631$3125 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3293 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3294_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3295_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11655$3131 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:11653$3130 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11669$3136 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11667$3135 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ge$top.v:11661$3133 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:11665$3134 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11697$3144 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11695$3143 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$add$top.v:11691$3142
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n767__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n559__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<61,56>().concat(value<2>{0u}).val() : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n544__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<61,56>().concat(value<2>{0u}).val() : value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n535__o ? value<4>{0x9u} : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<38>().val() ? value<4>{0x7u} : value<3>{0u}.concat((and_uu<1>(eq_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<6>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<3,0>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<3,0>().val()), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<25,22>().val()), and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n698__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n678__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<3,0>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n698__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n678__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<3,0>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<3,0>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<16>().val(), and_uu<1>(eq_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<14>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<11,8>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<11,8>().val()), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<21,18>().val()), and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n632__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n612__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<11,8>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n632__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n612__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<11,8>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<11,8>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<17>().val()))))) ? value<1>{0u} : value<1>{0x1u})).val()))).concat(value<3>{0x3u}).val()));
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:11561$3106 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11557$3104
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n545__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<7,0>().val(), value<4>{0xau}), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n544__o);
	// \src: top.v:11869.19-11869.43
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11869$3181
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n872__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n775__o ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<53,46>()).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n504__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<7,0>()).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11741$3155 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11726$3151 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11729$3152 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11733$3153
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n764__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n559__o ? value<30>{0x10200000u} : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n544__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<45,42>().val() : value<4>{0x4u}).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n544__o ? value<1>{0x1u} : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n544__o ? value<1>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n535__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<38,16>()).val() : value<25>{0x200000u})).val());
	// \src: top.v:11865.19-11865.43
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11865$3180
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n869__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n775__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<25,0>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n503__o.concat(value<1>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<17>()).concat(p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<7,0>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<15,8>()).val());
	// \src: top.v:1496.20-1496.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1496$416
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6336__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<2,0>().val());
	// \src: top.v:1635.20-1635.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1635$449
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6464__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<2,0>().val(), value<3>{0x4u});
	// \src: top.v:1631.20-1631.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1631$448
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6455__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<2,0>().val(), value<2>{0x3u});
	// \src: top.v:1629.20-1629.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1629$447
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6450__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<2,0>().val(), value<2>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5158$1766 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5156$1765 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5154$1764 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5152$1763 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5148$1761 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5146$1760 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5142$1759
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted = and_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<8>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4922__q.curr.slice<4>().val())), (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4229__o ? value<1>{0x1u} : value<1>{0u})), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr));
	// \src: top.v:5214.20-5214.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5214$1784
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4323__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr, value<3>{0x7u});
	// \src: top.v:5140.20-5140.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5140$1758
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4222__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3497__o, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample);
	// \src: top.v:5164.20-5164.39
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5164$1769
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4252__o = add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr, value<1>{0x1u});
	// \src: top.v:1044.20-1044.41
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1044$329
	p_unity__link__inst_2e_core__inst_2e_n198__o = and_uu<1>(p_out__valid.curr, p_out__ready);
	// \src: top.v:1088.20-1088.41
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$eq$top.v:1088$351
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6531__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2633$830 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4255 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4247_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4248_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4249_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4250_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4251_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4252_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4253_CMP0
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5507__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<7>().val() ? value<5>{0u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5494__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5485__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5476__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5467__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5346__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5449__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5437__o).val(), value<1>{0x1u}) ? value<5>{0xdu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5494__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5485__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5476__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5467__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5346__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5449__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5437__o).val(), value<2>{0x2u}) ? value<5>{0x11u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5494__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5485__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5476__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5467__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5346__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5449__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5437__o).val(), value<3>{0x4u}) ? value<5>{0xbu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5494__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5485__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5476__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5467__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5346__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5449__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5437__o).val(), value<4>{0x8u}) ? value<5>{0x13u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5494__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5485__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5476__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5467__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5346__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5449__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5437__o).val(), value<5>{0x10u}) ? value<5>{0xeu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5494__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5485__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5476__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5467__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5346__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5449__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5437__o).val(), value<6>{0x20u}) ? value<5>{0x18u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5494__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5485__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5476__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5467__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5346__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5449__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5437__o).val(), value<7>{0x40u}) ? value<5>{0x10u} : value<5>{0u}))))))));
	// \src: top.v:2639.20-2639.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2639$832
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5516__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<7,3>().val(), value<5>{0x12u});
	// \full_case: 1
	// \src: top.v:3117.33-3117.33|top.v:3115.5-3120.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4226
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6058__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4227__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<18,15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4228__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<30,27>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4229__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6187__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<71,68>().val())));
	// \full_case: 1
	// \src: top.v:3017.33-3017.33|top.v:3015.5-3020.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4231
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5954__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4227__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<18,15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4228__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<30,27>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4229__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6185__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<71,68>().val())));
	// \full_case: 1
	// \src: top.v:2931.33-2931.33|top.v:2929.5-2934.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4236
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5861__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4227__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<18,15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4228__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<30,27>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4229__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6183__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<71,68>().val())));
	// \full_case: 1
	// \src: top.v:2835.33-2835.33|top.v:2833.5-2838.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4241
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5758__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4227__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<18,15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4228__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<30,27>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4229__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6181__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<71,68>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7632$2317 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7630$2316 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7628$2315 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7624$2313
	p_unity__link__inst_2e_core__inst_2e_answer__has__id = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<20>().val(), (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2398__o, eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19,16>().val(), value<4>{0xfu})) ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2298$724 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2296$723 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2294$722 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2290$721
	p_unity__link__inst_2e_core__inst_2e_answer__taken = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5091__o, p_unity__link__inst_2e_core__inst_2e_answer__valid), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<78>().val(), not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available.curr)));
	// \src: top.v:2445.20-2445.51
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2445$766
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5259__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5113__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6179__q.curr.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6179__q.curr.slice<15,7>()).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<71,31>().val());
	// \full_case: 1
	// \src: top.v:3367.37-3367.37|top.v:3363.5-3372.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4094_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4094__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5755__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5141__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5183__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5160__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5727__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5565__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5083__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:3368.37-3368.37|top.v:3363.5-3372.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4093_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4093__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5755__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5141__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5183__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5160__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5727__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5565__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5083__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:3363.19-3363.19|top.v:3363.5-3372.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4098_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4098__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5755__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5141__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5183__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5160__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5727__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5565__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5083__o).val(), value<7>{0x40u});
	// \full_case: 1
	// \src: top.v:3364.37-3364.37|top.v:3363.5-3372.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4097_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4097__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5755__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5141__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5183__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5160__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5727__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5565__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5083__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:3365.37-3365.37|top.v:3363.5-3372.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4096_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4096__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5755__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5141__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5183__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5160__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5727__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5565__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5083__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:3366.37-3366.37|top.v:3363.5-3372.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4095_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5755__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5141__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5183__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5160__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5727__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5565__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5083__o).val(), value<4>{0x8u});
	// \src: top.v:4869.20-4869.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4869$1666
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3858__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4930__q.curr);
	// \src: top.v:4930.20-4930.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4930$1691
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr, value<2>{0x3u});
	// \src: top.v:4900.20-4900.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4900$1679
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3898__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr, value<4>{0x9u});
	// \src: top.v:4895.20-4895.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4895$1677
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3893__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr, value<4>{0xau});
	// \src: top.v:4925.20-4925.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4925$1689
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3923__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr, value<3>{0x4u});
	// \src: top.v:4890.20-4890.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4890$1675
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3888__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr, value<4>{0xbu});
	// \src: top.v:4920.20-4920.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4920$1687
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3918__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr, value<3>{0x5u});
	// \src: top.v:4885.20-4885.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4885$1673
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3883__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr, value<4>{0xcu});
	// \src: top.v:4915.20-4915.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4915$1685
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3913__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr, value<3>{0x6u});
	// \src: top.v:4946.20-4946.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4946$1697
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3943__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr);
	// \src: top.v:4880.20-4880.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4880$1671
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3878__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr, value<4>{0xdu});
	// \src: top.v:4940.20-4940.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4940$1695
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3938__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr, value<1>{0x1u});
	// \src: top.v:4935.20-4935.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4935$1693
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3933__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr, value<2>{0x2u});
	// \src: top.v:4910.20-4910.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4910$1683
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3908__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr, value<3>{0x7u});
	// \src: top.v:4875.20-4875.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4875$1669
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3873__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr, value<4>{0xeu});
	// \src: top.v:4905.20-4905.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4905$1681
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3903__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr, value<4>{0x8u});
	// \src: top.v:4871.20-4871.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4871$1667
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3867__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr, value<4>{0xfu});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5560$1932 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5558$1931
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4727__o = (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5555$1930 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5552$1929
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4722__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr, value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5550$1928 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5547$1927
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4716__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr, value<2>{0x2u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5545$1926 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5542$1925
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4710__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr, value<2>{0x3u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5540$1924 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5537$1923
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4704__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr, value<3>{0x4u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5535$1922 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5532$1921
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4698__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr, value<3>{0x5u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5530$1920 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5527$1919
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4692__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr, value<3>{0x6u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5525$1918 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5522$1917
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4686__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr, value<3>{0x7u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5520$1916 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5517$1915
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4680__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr, value<4>{0x8u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5515$1914 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5512$1913
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4674__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr, value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5510$1912 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5507$1911
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4668__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr, value<4>{0xau}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5505$1910 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5502$1909
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4662__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr, value<4>{0xbu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5500$1908 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5497$1907
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4656__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr, value<4>{0xcu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5495$1906 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5492$1905
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4650__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr, value<4>{0xdu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5490$1904 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5487$1903
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4644__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr, value<4>{0xeu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5485$1902 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5483$1901
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4637__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr, value<4>{0xfu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4957$1702 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4955$1701
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3858__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4930__q.curr));
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:306$58 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:304$57 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ne$top.v:302$56 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:300$55 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4363 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4368 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4373 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4378 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4383
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counts = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr, (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4339__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr.slice<15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr.slice<14>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4346__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr.slice<13>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4347__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr.slice<12>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4340__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr.slice<11>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr.slice<10>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4346__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr.slice<9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4347__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr.slice<8>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4341__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr.slice<7>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr.slice<6>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4346__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr.slice<5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4347__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr.slice<4>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4342__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr.slice<3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr.slice<2>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4346__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr.slice<1>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4347__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr.slice<0>().val() : value<1>{0u})))) : value<1>{0u}))))), (reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor.curr) ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12120$3232 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$not$top.v:12118$3231
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o));
	// \src: top.v:11402.19-11402.34
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11402$3074
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n395__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<17,16>().val());
	// \full_case: 1
	// \src: top.v:1712.19-1712.19|top.v:1712.5-1719.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4281_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4281__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6464__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6455__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6450__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6199__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6336__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:1713.32-1713.32|top.v:1712.5-1719.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4280_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4280__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6464__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6455__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6450__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6199__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6336__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:1714.32-1714.32|top.v:1712.5-1719.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4279_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4279__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6464__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6455__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6450__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6199__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6336__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:1716.35-1716.35|top.v:1712.5-1719.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4277_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4277__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6464__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6455__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6450__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6199__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6336__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:1715.32-1715.32|top.v:1712.5-1719.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4278_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4278__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6464__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6455__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6450__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6199__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6336__o).val(), value<2>{0x2u});
	// \src: top.v:7514.20-7514.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7514$2280
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10966$3055 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10620$2935
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2065__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1682__o ? value<1>{0x1u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1703__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<112,105>().concat(value<1>{0x1u}).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<124,117>().concat(value<1>{0u}).val())).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<125,117>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10560$2918 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10544$2915 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10532$2912 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3319 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3320_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3321_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$sub$top.v:10389$2862 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3383 $auto$opt_reduce.cc:131:opt_pmux$4732 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10550$2916 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3380 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3377 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3373 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3368 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3362 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3355 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3347 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10252$2845 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10524$2910 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10534$2913 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10519$2909 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10538$2914 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10528$2911
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1679__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<124,117>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<115,8>()).val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1482__o ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<112,105>().concat(value<1>{0x1u}).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<124,117>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<124,117>().concat(value<1>{0u}).val()).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1478__o.slice<10>()).concat((and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1482__o) ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<113>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1478__o.slice<8,0>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1643__o)).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1478__o.slice<9,0>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3339__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<114>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<100,73>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : value<28>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<104,73>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3356__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<68,57>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<72,57>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3363__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<52,49>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<56,49>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3369__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,41>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3374__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<36,33>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<40,33>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3378__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<28,25>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<32,25>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3381__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<20,17>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<24,17>().val())).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<124,117>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<115,17>()).val()).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3339__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3356__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3363__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3369__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3374__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3378__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3381__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<16>().val() : value<1>{0x1u}).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1482__o ? value<1>{0u}.concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1624__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1621__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1618__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1612__o).val(), value<3>{0x4u}) ? value<3>{0x7u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1624__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1621__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1618__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1612__o).val(), value<4>{0x8u}) ? value<3>{0x3u} : value<3>{0x1u}))).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o).val() : sub_uu<4>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left, value<1>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field).val())).val() : value<1>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field).val())).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$and$top.v:916$312 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$not$top.v:914$311 $flatten\unity_link_inst.\core_inst.$or$top.v:13019$3280 $flatten\unity_link_inst.\core_inst.$or$top.v:13017$3279 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$or$top.v:1369$389 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1367$388 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ne$top.v:1365$387 $flatten\unity_link_inst.\core_inst.$or$top.v:13015$3278 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2348$738 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2346$737 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:2344$736 $flatten\unity_link_inst.\core_inst.$or$top.v:13013$3277 $flatten\unity_link_inst.\core_inst.$or$top.v:13011$3276 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10016$2795 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10014$2794 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10012$2793 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:10010$2792 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:10006$2791 $flatten\unity_link_inst.\core_inst.$or$top.v:13009$3275 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:11396$3073 $flatten\unity_link_inst.\core_inst.$or$top.v:13007$3274
	p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6609__o = and_uu<1>(not_u<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr, p_unity__link__inst_2e_core__inst_2e_character__valid.curr), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<40>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<54>().val())), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<126>().val(), (or_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<4,0>().val(), value<5>{0x10u}), reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<11,8>().val())) ? value<1>{0x1u} : value<1>{0u}))), p_unity__link__inst_2e_core__inst_2e_hold), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<88>().val(), (reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<2,0>().val()) ? value<1>{0x1u} : value<1>{0u}))), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<25>().val(), (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<2,0>().val(), value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u}))), p_out__valid.curr)), p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6639__q.curr);
	// \src: top.v:5216.20-5216.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5216$1785
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4330__o = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4323__o ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5208$1781 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5206$1780
	p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write = or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4272__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4285__o), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4222__o);
	// \src: top.v:5228.20-5228.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5228$1791
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4346__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr, value<4>{0x9u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7510$2279 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7508$2278
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__done, (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3562__o ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8672$2625 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8657$2619 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8278$2513 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3732 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8630$2610 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8621$2607 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3620 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3622_CMP0 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8634$2611 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8637$2612 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8641$2613 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8019$2438 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3792
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3127__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<14>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<133>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<13,12>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2719__o).concat(value<3>{0x7u}).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2699__o.concat(value<1>{0u}).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3639__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<24,17>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2719__o)).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2693__o).val()) : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<13,12>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3081__o.slice<10,9>().val()).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<15>().val() ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3081__o.slice<8>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<10,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3081__o.slice<7,0>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<15>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<11>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val() : value<3>{0x7u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3604__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3051__o.slice<2,0>().val() : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1701__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3071__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3062__o).val(), value<3>{0x4u}) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val() : value<3>{0x7u})))).val()) : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<133>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<13,3>().concat(value<3>{0x7u}).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2699__o.concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3639__CMP ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<24,17>()).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<11,3>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2693__o).val()));
	// \src: top.v:7774.20-7774.44
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:7774$2367
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2542__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<132,129>().val());
	// \src: top.v:8857.20-8857.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8857$2684
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val(), value<3>{0x5u});
	// \src: top.v:8826.20-8826.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8826$2675
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val(), value<2>{0x3u});
	// \src: top.v:8734.20-8734.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8734$2646
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val(), value<2>{0x2u});
	// \src: top.v:8732.20-8732.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8732$2645
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6271$2140 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6265$2137 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6263$2136 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6261$2135 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6259$2134
	p_unity__link__inst_2e_core__inst_2e_access__granted = and_uu<1>(and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<56>().val(), not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3458__o)), not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.curr)), p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3468__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7552$2295 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7550$2294 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7504$2276 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7502$2275 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7500$2274
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2315__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__done, (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_access__failure.curr) ? value<1>{0x1u} : value<1>{0u})), not_u<1>(p_unity__link__inst_2e_core__inst_2e_access__write));
	// \src: top.v:6327.20-6327.48
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:6327$2168
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3541__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3650__q.curr);
	// \src: top.v:6347.20-6347.34
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:6347$2178
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3560__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.curr, value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7532$2286 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7530$2285 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7528$2284
	p_unity__link__inst_2e_core__inst_2e_access__more = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue));
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1084$349 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$not$top.v:1082$348
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6549__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_n198__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6500__o));
	// \src: top.v:2635.20-2635.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:2635$831
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5509__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5507__o);
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2683$848 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2677$845 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2671$842
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5558__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5516__o ? value<6>{0x3u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5521__o ? value<6>{0x3fu} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<9>().val() ? value<2>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<22,19>()).val() : value<3>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5549__o_5b_2_3a_0_5d_).val())));
	// \src: top.v:2878.20-2878.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$sub$top.v:2878$907
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5798__o = sub_uu<6>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<77,72>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2685$849 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2679$846 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2673$843 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2661$837
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5559__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5516__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5521__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<9>().val() ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5550__o ? value<1>{0x1u} : value<1>{0u}))));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:3083$958 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:3076$955
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6019__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<39,31>().val(), value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5144__o);
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2681$847 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2675$844 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2669$841
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5557__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5516__o ? value<3>{0x5u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5521__o ? value<3>{0x6u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<9>().val() ? value<3>{0x3u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5548__o)));
	// cell $auto$opt_reduce.cc:131:opt_pmux$4718
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4691 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4093__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4094__CMP).val());
	// \full_case: 1
	// \src: top.v:3369.37-3369.37|top.v:3363.5-3372.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4092_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5755__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5141__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5183__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5160__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5727__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5565__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5083__o).val(), value<1>{0x1u});
	// cell $auto$opt_reduce.cc:131:opt_pmux$4752
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4743 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4096__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4097__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4098__CMP).val());
	// \src: top.v:4951.20-4951.28
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4951$1699
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3946__o = not_u<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr);
	// \src: top.v:5427.20-5427.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5427$1873
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4578__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr, value<3>{0x4u});
	// \src: top.v:5425.20-5425.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5425$1872
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4576__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr, value<2>{0x3u});
	// \src: top.v:5423.20-5423.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5423$1871
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr, value<2>{0x2u});
	// \src: top.v:5413.20-5413.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5413$1866
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4563__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr, value<1>{0x1u});
	// \src: top.v:5240.20-5240.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5240$1797
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4368__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<60,58>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5238$1796 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5236$1795 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$or$top.v:293$54 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$or$top.v:291$53 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$or$top.v:289$52 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5234$1794
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out = and_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4356__o ? value<1>{0x1u} : value<1>{0u}), not_u<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6972__q.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6974__q.curr), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick.curr)));
	// \full_case: 1
	// \src: top.v:6065.32-6065.32|top.v:6062.5-6067.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3886_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3886__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<42,41>().val(), value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:6064.32-6064.32|top.v:6062.5-6067.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3887_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3887__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<42,41>().val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6063.32-6063.32|top.v:6062.5-6067.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3888_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3888__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<42,41>().val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:6062.19-6062.19|top.v:6062.5-6067.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3889_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3889__CMP = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<42,41>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:312$61 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:310$60 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:308$59
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counts, (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter.curr, value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1489$413 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1484$412 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1480$411 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$add$top.v:1476$410 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1472$409 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4612
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6331__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<88>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6284__o_5b_2_3a_0_5d_.slice<2>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6291__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6298__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6305__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6312__o_5b_2_3a_0_5d_.slice<2>()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6277__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6312__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6312__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val())).concat(add_uu<2>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<4,3>().val(), value<1>{0x1u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<4,3>().val(), value<2>{0x2u}) ? value<3>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<2,0>().val())).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<12,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$and$top.v:912$310 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$eq$top.v:910$309
	p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6607__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark.curr, value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left.curr);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3733$1527 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2328$735 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2326$734 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$add$top.v:3731$1526
	p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5030__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5113__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<78>().val())) ? add_uu<11>(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5061__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5061__q.curr);
	// \src: top.v:5230.20-5230.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5230$1792
	p_unity__link__inst_2e_core__inst_2e_group__done = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4346__o ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:8835.20-8835.44
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8835$2678
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3259__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<54,47>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<141,134>().val());
	// \full_case: 1
	// \src: top.v:9057.19-9057.19|top.v:9057.5-9067.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3481_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3481__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o).val(), value<8>{0x80u});
	// \full_case: 1
	// \src: top.v:9058.38-9058.38|top.v:9057.5-9067.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3480_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3480__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o).val(), value<7>{0x40u});
	// \full_case: 1
	// \src: top.v:9059.38-9059.38|top.v:9057.5-9067.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3479_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3479__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:9060.38-9060.38|top.v:9057.5-9067.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3478_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3478__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:9061.38-9061.38|top.v:9057.5-9067.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3477_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:9062.38-9062.38|top.v:9057.5-9067.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3476_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3476__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:9063.38-9063.38|top.v:9057.5-9067.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3475_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o).val(), value<2>{0x2u});
	// \src: top.v:8742.20-8742.41
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$add$top.v:8742$2648
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3179__o = add_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<54,47>().val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:9064.38-9064.38|top.v:9057.5-9067.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3474_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o).val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\wishbone_master_inst.$and$top.v:12273$3272 $flatten\unity_link_inst.\wishbone_master_inst.$or$top.v:12271$3271
	p_unity__link__inst_2e_bus__done = and_uu<1>(p_wb__stb.curr, or_uu<1>(p_wb__ack, p_wb__err));
	// \src: top.v:6305.20-6305.40
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$or$top.v:6305$2157
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample, p_unity__link__inst_2e_core__inst_2e_access__granted);
	// \full_case: 1
	// \src: top.v:6463.19-6463.19|top.v:6463.5-6468.12
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3819_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3819__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3489__o.concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3560__o).concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3461__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:6464.35-6464.35|top.v:6463.5-6468.12
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3818_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3818__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3489__o.concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3560__o).concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3461__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6465.33-6465.33|top.v:6463.5-6468.12
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3817_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3489__o.concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3560__o).concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3461__o).val(), value<1>{0x1u});
	// cell $auto$opt_reduce.cc:131:opt_pmux$4730
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4731 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4093__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4094__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4096__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4098__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2475$773 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2448$767
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5278__o = (p_unity__link__inst_2e_core__inst_2e_answer__taken ? value<2>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5113__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6179__q.curr.slice<6>().concat(value<1>{0x1u}).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<79,78>().val()));
	// cell $auto$opt_reduce.cc:131:opt_pmux$4734
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4657 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4093__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4094__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4096__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4097__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4098__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2461$769 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7728$2352 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7720$2350 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2442$765
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5268__o = (p_unity__link__inst_2e_core__inst_2e_answer__taken ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<20>().concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2372__o ? value<5>{0x10u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<74>().val() ? value<5>{0x11u} : value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19,16>()).val()))).concat(value<3>{0x1u}).val() : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5113__o ? value<9>{0x91u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<8,0>().val()));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2465$770 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2418$762 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7650$2323 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7646$2321 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7644$2320 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7640$2319 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7730$2353 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7698$2343 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3804 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7690$2341 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7688$2340 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7686$2339 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7684$2338 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7682$2337 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7680$2336 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7678$2335 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7676$2334 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7674$2333 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7672$2332 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7670$2331 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7666$2329 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7662$2327 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7658$2325 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2423$763 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7722$2351 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7732$2354 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7636$2318
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5271__o = (p_unity__link__inst_2e_core__inst_2e_answer__taken ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2372__o ? value<4>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<73,70>()).val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,41>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<141,134>().val())).concat(value<4>{0x1u}).concat((p_unity__link__inst_2e_core__inst_2e_answer__has__id ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<74>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<10,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<30,23>().val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<32,25>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2372__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<20>().val() ? value<1>{0u} : (or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19,16>().val(), value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2229__o), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2214__o), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2217__o), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19,16>().val(), value<4>{0x8u})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19,16>().val(), value<4>{0x9u})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19,16>().val(), value<4>{0xau})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19,16>().val(), value<4>{0xbu})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19,16>().val(), value<4>{0xcu})) ? value<1>{0x1u} : value<1>{0u})))).concat(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_answer__has__id, and_uu<1>(and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<20>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19>().val())), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2398__o))).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<30,9>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:4953$1700 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4948$1698 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4943$1696 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4938$1694 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4933$1692 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4928$1690 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4923$1688 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4918$1686 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4913$1684 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4908$1682 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4903$1680 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4898$1678 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4893$1676 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4888$1674 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4883$1672 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4878$1670 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4873$1668
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer = or_uu<16>((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3867__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u}).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3873__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3878__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3883__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3888__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3893__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3898__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3903__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3908__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3913__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3918__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3923__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3933__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3938__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3943__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).val(), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3946__o);
	// \full_case: 1
	// \src: top.v:5821.40-5821.40|top.v:5813.5-5825.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3944_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4346__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4356__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4323__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4214__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4263__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4578__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4576__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4563__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:5820.40-5820.40|top.v:5813.5-5825.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3945_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4346__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4356__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4323__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4214__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4263__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4578__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4576__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4563__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:5819.40-5819.40|top.v:5813.5-5825.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3946_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4346__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4356__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4323__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4214__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4263__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4578__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4576__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4563__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:5818.41-5818.41|top.v:5813.5-5825.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3947_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4346__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4356__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4323__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4214__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4263__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4578__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4576__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4563__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:5817.41-5817.41|top.v:5813.5-5825.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3948_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4346__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4356__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4323__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4214__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4263__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4578__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4576__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4563__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:5816.40-5816.40|top.v:5813.5-5825.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3949_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4346__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4356__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4323__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4214__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4263__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4578__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4576__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4563__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<7>{0x40u});
	// \full_case: 1
	// \src: top.v:5815.40-5815.40|top.v:5813.5-5825.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3950_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4346__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4356__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4323__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4214__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4263__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4578__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4576__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4563__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<8>{0x80u});
	// \full_case: 1
	// \src: top.v:5814.40-5814.40|top.v:5813.5-5825.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3951_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3951__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4346__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4356__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4323__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4214__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4263__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4578__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4576__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4563__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<9>{0x100u});
	// \full_case: 1
	// \src: top.v:5813.19-5813.19|top.v:5813.5-5825.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3952_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3952__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4346__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4356__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4323__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4214__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4263__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4578__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4576__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4563__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<10>{0x200u});
	// \full_case: 1
	// \src: top.v:5822.40-5822.40|top.v:5813.5-5825.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3943_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4346__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4356__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4323__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4214__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4263__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4578__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4576__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4563__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<1>{0x1u});
	// \src: top.v:5075.20-5075.25
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5075$1738
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4111__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<9>().val());
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12110$3227 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$not$top.v:12108$3226
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n286__o = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o), p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o);
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12100$3222 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$or$top.v:12098$3221 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12096$3220 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$eq$top.v:12092$3218
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n279__o = and_uu<1>(or_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o, p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n276__o)), p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o);
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1074$344 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$not$top.v:1072$343
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6541__o = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_n198__o), p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6500__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10997$3063 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7516$2281
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2087__o = and_uu<1>((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<126>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10993$3062 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9938$2779 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9932$2776 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10975$3057 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10555$2917 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10174$2830 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3398 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3445 $auto$opt_reduce.cc:131:opt_pmux$4728 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3432 $auto$opt_reduce.cc:131:opt_pmux$4740 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3422 $auto$opt_reduce.cc:131:opt_pmux$4738 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3410 $auto$opt_reduce.cc:131:opt_pmux$4736 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3392 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3436 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3428 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3416 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3404 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10182$2831 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10190$2833 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10188$2832 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10978$3058 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10616$2934 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10962$3054 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10611$2933 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10981$3059 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10985$3060 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10989$3061 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10969$3056 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10958$3053 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:10803$2999 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10956$3052 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10835$3009 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10817$3003 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10807$3000 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10815$3002 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10813$3001 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10833$3008 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10831$3007 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10829$3006 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10823$3004 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10954$3051 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10950$3049 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3301 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3302_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3303_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3304_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10917$3040 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10913$3038 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10909$3036 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10905$3034 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10897$3030 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10911$3037 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10907$3035 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10877$3023 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10899$3031 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10895$3029 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10933$3044 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10923$3042 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10931$3043 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10767$2987 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3310 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3311_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3312_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3313_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3314_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3315_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10642$2942 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:10640$2941 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10665$2950 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10658$2949 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:10654$2947 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:10656$2948 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10722$2971 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10715$2970 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:10713$2969 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10709$2968 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10703$2966 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10701$2965 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10697$2964 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:10695$2963 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:10746$2981 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3306 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3307_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3308_CMP0
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2085__o = (and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<54>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1154__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1157__o) ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<55>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1682__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<141,126>().val() : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1901__o).val(), value<1>{0x1u}) ? value<8>{0x1u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1901__o).val(), value<2>{0x2u}) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<112,105>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<40,33>().val())).concat(((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1804__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<1>{0x1u}) ? or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1760__o, gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<40,33>().val(), value<8>{0xffu})) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1804__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<2>{0x2u}) ? or_uu<1>(and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<2>{0x3u}), gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<113,105>().val(), value<8>{0xffu})), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<115>().val()) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1804__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<3>{0x4u}) ? or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1807__o, reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<56,55>().concat(value<6>{0u}).val())), logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<72,57>().val())), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1760__o), gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<40,33>().val(), value<6>{0x20u})), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<115>().val()) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1804__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<4>{0x8u}) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1807__o : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1804__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<5>{0x10u}) ? gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,41>().val(), value<2>{0x2u}) : value<1>{0u}))))) ? value<1>{0x1u} : value<1>{0u})).concat((reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<60,57>().val()) ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<60,57>().val() : (and_uu<1>(not_u<1>(and_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<4>{0xeu}), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<5>().val())), and_uu<1>(not_u<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<6>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<7>().val())), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<4>().val()))) ? value<2>{0u}.concat(((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<16>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1954__o : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1962__o).val(), value<1>{0x1u}) ? value<1>{0x1u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1962__o).val(), value<2>{0x2u}) ? ((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<16>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1948__o : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1973__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1803__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2006__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1948__o)))) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1973__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1803__o ? eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<113,105>().val(), value<2>{0x2u}) : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2006__o ? eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<113,105>().val(), value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1954__o)))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1962__o).val(), value<3>{0x4u}) ? and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<113,105>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<40,33>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<114>().val())) : value<1>{0u})))) ? value<2>{0u} : value<2>{0x3u})).val() : value<4>{0x2u}))).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<61>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<56>()).concat(value<1>{0x1u}).val()).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2065__o.slice<9>()).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<141,125>().val()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<55>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2065__o.slice<8,0>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1679__o.slice<116,108>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<55>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<115>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1679__o.slice<107>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<55>().val() ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1703__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1682__o) ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<113>().val() ? value<1>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<112,105>()).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1643__o)).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<114,105>().val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1679__o.slice<106,97>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<55>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<104,0>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1679__o.slice<96,0>().concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter ? or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<7>().val(), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<51>().val())).concat(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<6>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<51>().val())).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<51>()).concat(((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3393__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3437__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3438__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3439__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3440__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3441__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3442__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3443__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3394__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3429__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3430__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3395__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3417__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3418__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3419__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3420__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3396__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3405__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3406__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3407__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3408__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : value<1>{0x1u})))) ? value<5>{0x1fu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3393__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3437__CMP ? value<5>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3438__CMP ? value<5>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3439__CMP ? value<5>{0xdu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3440__CMP ? value<5>{0xeu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3441__CMP ? value<5>{0xfu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3442__CMP ? value<5>{0xcu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3443__CMP ? value<5>{0x11u} : value<5>{0u}))))))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3394__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3429__CMP ? value<5>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3430__CMP ? value<5>{0x2u} : value<5>{0u})) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3395__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3417__CMP ? value<5>{0x5u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3418__CMP ? value<5>{0x7u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3419__CMP ? value<5>{0x6u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3420__CMP ? value<5>{0x3u} : value<5>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3396__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3405__CMP ? value<5>{0x8u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3406__CMP ? value<5>{0x9u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3407__CMP ? value<5>{0xau} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3408__CMP ? value<5>{0xbu} : value<5>{0u})))) : value<5>{0u})))))).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<7,0>().val())).val())).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<141,117>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<115,0>()).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$and$top.v:908$308 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$eq$top.v:906$307
	p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6604__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark.curr, value<2>{0x2u}), p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left.curr);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3727$1524 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5226$1790 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5224$1789 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3725$1523 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$add$top.v:3723$1522
	p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5026__o = (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4330__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted)) ? p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.curr : (p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write ? add_uu<11>(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5059__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5059__q.curr));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8712$2638 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8688$2631 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8692$2632
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3154__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<126>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2542__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<13,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3127__o.slice<13,3>().val()).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2542__o ? value<3>{0x7u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3127__o.slice<2,0>().val())).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<13,0>().val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$4714
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4695 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3476__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3478__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3479__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3480__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3481__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8715$2639 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8694$2633 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8674$2626
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3156__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<126>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<141,134>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<32,17>()).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<128,127>()).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2542__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<5>().val() ? value<1>{0x1u} : value<1>{0u}))).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>()).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<46,16>().val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$4708
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4697 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3476__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3478__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3479__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3480__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3481__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8822$2673 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8803$2667 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8788$2662 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8778$2659 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8807$2668 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8791$2663
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3245__o = (p_unity__link__inst_2e_core__inst_2e_access__done ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<57>().val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2254__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<57>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2254__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<56>().val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<56>().val())))).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<57,56>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8717$2640 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8697$2634 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8676$2627 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8661$2621 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8646$2615 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3610 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8700$2635 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8678$2628 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8663$2622 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8649$2616 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3607
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3157__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<126>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2542__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<60,58>().val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<14>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2714__o : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<60,58>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3604__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2714__o : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<60,58>().val()))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2714__o)).concat(value<1>{0u}).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2542__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<56>().val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<14>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2712__o : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<56>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3604__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2712__o : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<56>().val()))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2712__o))).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<60,56>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8720$2641 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8703$2636 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8681$2629 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8666$2623 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8651$2617 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3603 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3605_CMP0 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8706$2637 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8684$2630 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8669$2624 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8653$2618 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8626$2609
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3159__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<126>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2542__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<14>().val() ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<15>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<11>().val() ? value<1>{0u} : value<1>{0x1u}) : value<1>{0u})) : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2542__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<132,129>().val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<14>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2715__o : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<15>().val() ? value<4>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3604__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2715__o : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1701__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3071__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3062__o).val(), value<2>{0x2u}) ? value<4>{0x8u} : value<4>{0u})))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2715__o))).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<74,70>().val());
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6591$2229 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7572$2302 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7570$2301 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6589$2228 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$add$top.v:6587$2227
	p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3404__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2326__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<22>().val())) ? p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.curr : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2315__o ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3437__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3437__q.curr));
	// cell $auto$opt_reduce.cc:131:opt_pmux$4678
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4679 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3818__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3819__CMP).val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$4688
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4687 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3819__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1064$339 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$or$top.v:1062$338 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1060$337 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$eq$top.v:1056$335
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6534__o = and_uu<1>(or_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_n198__o, p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6531__o)), p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6500__o);
	// \src: top.v:851.20-851.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$eq$top.v:851$300
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6647__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6661__q.curr);
	// cell $auto$opt_reduce.cc:131:opt_pmux$4670
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4669 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3951__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3952__CMP).val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$4658
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4653 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3951__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3952__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5244$1799 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5242$1798
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4376__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4368__o ? value<1>{0x1u} : value<1>{0u}));
	// \src: top.v:5256.20-5256.39
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5256$1805
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4398__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4330__o);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$or$top.v:327$65 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5250$1802 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5248$1801 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5246$1800
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6719__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counts, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out, (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<60,58>().val(), value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u})));
	// memory \unity_link_inst.core_inst.rx_fifo_inst.memory read port 0
	auto tmp_4 = memory_index(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n334__q.curr, 0, 256);
	CXXRTL_ASSERT(tmp_4.valid && "out of bounds read");
	if(tmp_4.valid) {
		value<9> tmp_5 = memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory[tmp_4.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_12178_24_3257__DATA = tmp_5;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_12178_24_3257__DATA = value<9> {};
	}
	// \src: top.v:1046.20-1046.51
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1046$330
	p_unity__link__inst_2e_core__inst_2e_tx__entry = (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6596__q.curr ? p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.curr : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6597__data.curr);
	// memory \unity_link_inst.core_inst.tx_fifo_inst.memory read port 0
	auto tmp_6 = memory_index(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6589__q.curr, 0, 256);
	CXXRTL_ASSERT(tmp_6.valid && "out of bounds read");
	if(tmp_6.valid) {
		value<10> tmp_7 = memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory[tmp_6.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_1142_24_374__DATA = tmp_7;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_1142_24_374__DATA = value<10> {};
	}
	// \full_case: 1
	// \src: top.v:9094.9-9094.14|top.v:9094.5-9095.41
	// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procmux$3464
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_9095_24_2706__EN_5b_31_3a_0_5d__24_2712_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<116>().val() ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:12180.9-12180.13|top.v:12180.5-12181.35
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$3282
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_12181_24_3210__EN_5b_8_3a_0_5d__24_3261_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:5944.9-5944.23|top.v:5944.5-5945.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3933
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5945_24_1567__EN_5b_13_3a_0_5d__24_2025_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4376__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:5944.9-5944.23|top.v:5944.5-5945.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3939
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5945_24_1567__ADDR_5b_3_3a_0_5d__24_2023 = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4376__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr : value<4>{0u});
	// \full_case: 1
	// \src: top.v:5972.9-5972.20|top.v:5972.5-5973.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3924
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_state__memory_24_top_2e_v_3a_5973_24_1584__EN_5b_9_3a_0_5d__24_2034_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4398__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:1144.9-1144.13|top.v:1144.5-1145.35
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$4328
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_1145_24_327__EN_5b_9_3a_0_5d__24_378_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6500__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:3773.9-3773.14|top.v:3773.5-3774.37
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procmux$4082
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_3774_24_1521__EN_5b_31_3a_0_5d__24_1547_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:6637.9-6637.14|top.v:6637.5-6638.37
	// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procmux$3807
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_6638_24_2226__EN_5b_31_3a_0_5d__24_2252_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2315__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:5982.9-5982.19|top.v:5982.5-5983.37
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3915
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_list_24_top_2e_v_3a_5983_24_1585__EN_5b_7_3a_0_5d__24_2043_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<61>().val() ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:635.9-635.22|top.v:635.5-636.44
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4398
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_counters_24_top_2e_v_3a_636_24_34__EN_5b_15_3a_0_5d__24_175_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6719__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:666.9-666.15|top.v:666.5-667.40
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4389
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_losses_24_top_2e_v_3a_667_24_51__EN_5b_7_3a_0_5d__24_186_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:5992.9-5992.18|top.v:5992.5-5993.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3906
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_last_24_top_2e_v_3a_5993_24_1586__EN_5b_31_3a_0_5d__24_2052_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4222__o ? value<1>{0x1u} : value<1>{0u});
	// memory \unity_link_inst.core_inst.request_memory_inst.memory read port 0
	auto tmp_8 = memory_index(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<54,47>().val(), 0, 256);
	CXXRTL_ASSERT(tmp_8.valid && "out of bounds read");
	if(tmp_8.valid) {
		value<32> tmp_9 = memory_p_unity__link__inst_2e_core__inst_2e_request__memory__inst_2e_memory[tmp_8.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2166__data_5b_31_3a_0_5d_ = tmp_9;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2166__data_5b_31_3a_0_5d_ = value<32> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_sample_ring_inst.memory read port 0
	auto tmp_10 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5061__q.curr.slice<9,0>().val(), 0, 1024);
	CXXRTL_ASSERT(tmp_10.valid && "out of bounds read");
	if(tmp_10.valid) {
		value<32> tmp_11 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_memory[tmp_10.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_5c_n5066__data_5b_31_3a_0_5d_ = tmp_11;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_5c_n5066__data_5b_31_3a_0_5d_ = value<32> {};
	}
	// memory \unity_link_inst.core_inst.response_ring_inst.memory read port 0
	auto tmp_12 = memory_index(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3439__q.curr.slice<7,0>().val(), 0, 256);
	CXXRTL_ASSERT(tmp_12.valid && "out of bounds read");
	if(tmp_12.valid) {
		value<32> tmp_13 = memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory[tmp_12.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3444__data_5b_31_3a_0_5d_ = tmp_13;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3444__data_5b_31_3a_0_5d_ = value<32> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.losses read port 1
	auto tmp_14 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6973__q.curr, 0, 16);
	CXXRTL_ASSERT(tmp_14.valid && "out of bounds read");
	if(tmp_14.valid) {
		value<8> tmp_15 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses[tmp_14.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6998__data_5b_7_3a_0_5d_ = tmp_15;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6998__data_5b_7_3a_0_5d_ = value<8> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.losses read port 0
	auto tmp_16 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr, 0, 16);
	CXXRTL_ASSERT(tmp_16.valid && "out of bounds read");
	if(tmp_16.valid) {
		value<8> tmp_17 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses[tmp_16.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6996__data_5b_7_3a_0_5d_ = tmp_17;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6996__data_5b_7_3a_0_5d_ = value<8> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.counters read port 0
	auto tmp_18 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6973__q.curr, 0, 16);
	CXXRTL_ASSERT(tmp_18.valid && "out of bounds read");
	if(tmp_18.valid) {
		value<16> tmp_19 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters[tmp_18.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6992__data_5b_15_3a_0_5d_ = tmp_19;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6992__data_5b_15_3a_0_5d_ = value<16> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.divisors read port 0
	auto tmp_20 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6973__q.curr, 0, 16);
	CXXRTL_ASSERT(tmp_20.valid && "out of bounds read");
	if(tmp_20.valid) {
		value<16> tmp_21 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors[tmp_20.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6988__data_5b_15_3a_0_5d_ = tmp_21;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6988__data_5b_15_3a_0_5d_ = value<16> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.settings_memory read port 0
	auto tmp_22 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr, 0, 16);
	CXXRTL_ASSERT(tmp_22.valid && "out of bounds read");
	if(tmp_22.valid) {
		value<14> tmp_23 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory[tmp_22.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4948__data_5b_13_3a_0_5d_ = tmp_23;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4948__data_5b_13_3a_0_5d_ = value<14> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.state_memory read port 0
	auto tmp_24 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr, 0, 16);
	CXXRTL_ASSERT(tmp_24.valid && "out of bounds read");
	if(tmp_24.valid) {
		value<10> tmp_25 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory[tmp_24.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4952__data_5b_9_3a_0_5d_ = tmp_25;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4952__data_5b_9_3a_0_5d_ = value<10> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.list read port 0
	auto tmp_26 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr.slice<4,0>()).val(), 0, 512);
	CXXRTL_ASSERT(tmp_26.valid && "out of bounds read");
	if(tmp_26.valid) {
		value<8> tmp_27 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_list[tmp_26.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4955__data_5b_7_3a_0_5d_ = tmp_27;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4955__data_5b_7_3a_0_5d_ = value<8> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.last read port 0
	auto tmp_28 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4936__q.curr.slice<4,0>()).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<9>()).val(), 0, 1024);
	CXXRTL_ASSERT(tmp_28.valid && "out of bounds read");
	if(tmp_28.valid) {
		value<32> tmp_29 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last[tmp_28.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4958__data_5b_31_3a_0_5d_ = tmp_29;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4958__data_5b_31_3a_0_5d_ = value<32> {};
	}
	// memory \unity_link_inst.core_inst.request_memory_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:9094.9-9094.14|top.v:9094.5-9095.41
		// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procmux$3470
		auto tmp_30 = memory_index((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<116>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<124,117>().val() : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_30.valid && "out of bounds write");
		if (tmp_30.valid) {
			// \full_case: 1
			// \src: top.v:9094.9-9094.14|top.v:9094.5-9095.41
			// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procmux$3467
			memory_p_unity__link__inst_2e_core__inst_2e_request__memory__inst_2e_memory.update(tmp_30.index, (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<116>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<104,73>().val() : value<32>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_9095_24_2706__EN_5b_31_3a_0_5d__24_2712_5b_0_5d_.repeat<32>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.rx_fifo_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:12180.9-12180.13|top.v:12180.5-12181.35
		// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$3288
		auto tmp_31 = memory_index((p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o ? p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n333__q.curr : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_31.valid && "out of bounds write");
		if (tmp_31.valid) {
			// \full_case: 1
			// \src: top.v:12180.9-12180.13|top.v:12180.5-12181.35
			// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$3285
			memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory.update(tmp_31.index, (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o ? p_in__lost.concat(p_in__data).val() : value<9>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_12181_24_3210__EN_5b_8_3a_0_5d__24_3261_5b_0_5d_.repeat<9>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.settings_memory write port 0
	if (posedge_p_clk) {
		auto tmp_32 = memory_index(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5945_24_1567__ADDR_5b_3_3a_0_5d__24_2023, 0, 16);
		CXXRTL_ASSERT(tmp_32.valid && "out of bounds write");
		if (tmp_32.valid) {
			// \full_case: 1
			// \src: top.v:5944.9-5944.23|top.v:5944.5-5945.42
			// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3936
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory.update(tmp_32.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4376__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<141,134>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<54,49>()).val() : value<14>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5945_24_1567__EN_5b_13_3a_0_5d__24_2025_5b_0_5d_.repeat<14>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.state_memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:5972.9-5972.20|top.v:5972.5-5973.41
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3930
		auto tmp_33 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4398__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr : value<4>{0u}), 0, 16);
		CXXRTL_ASSERT(tmp_33.valid && "out of bounds write");
		if (tmp_33.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3927 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5276$1815 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5270$1812 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5266$1810 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5268$1811 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5274$1814 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5278$1816 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5262$1808 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5264$1809 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5280$1817
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory.update(tmp_33.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4398__o ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4323__o) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4111__o : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<9>().val()).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4323__o ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<8>().val()) : value<1>{0x1u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4323__o ? (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr) ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4934__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4934__q.curr) : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4368__o ? value<8>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<7,0>().val()))).val() : value<10>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_state__memory_24_top_2e_v_3a_5973_24_1584__EN_5b_9_3a_0_5d__24_2034_5b_0_5d_.repeat<10>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.tx_fifo_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:1144.9-1144.13|top.v:1144.5-1145.35
		// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$4334
		auto tmp_34 = memory_index((p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6500__o ? p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6588__q.curr : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_34.valid && "out of bounds write");
		if (tmp_34.valid) {
			// \full_case: 1
			// \src: top.v:1144.9-1144.13|top.v:1144.5-1145.35
			// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$4331
			memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory.update(tmp_34.index, (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6500__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<24,15>().val() : value<10>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_1145_24_327__EN_5b_9_3a_0_5d__24_378_5b_0_5d_.repeat<10>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_sample_ring_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:3773.9-3773.14|top.v:3773.5-3774.37
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procmux$4088
		auto tmp_35 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write ? p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5059__q.curr.slice<9,0>().val() : value<10>{0u}), 0, 1024);
		CXXRTL_ASSERT(tmp_35.valid && "out of bounds write");
		if (tmp_35.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procmux$4085 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5210$1782 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5212$1783
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_memory.update(tmp_35.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4272__o ? value<4>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4934__q.curr).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4942__q.curr).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4922__q.curr.slice<3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4922__q.curr.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4922__q.curr.slice<2>()).concat(value<4>{0u}).val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4285__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4933__q.curr : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q.curr)) : value<32>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_3774_24_1521__EN_5b_31_3a_0_5d__24_1547_5b_0_5d_.repeat<32>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.response_ring_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:6637.9-6637.14|top.v:6637.5-6638.37
		// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procmux$3813
		auto tmp_36 = memory_index((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2315__o ? p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3437__q.curr.slice<7,0>().val() : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_36.valid && "out of bounds write");
		if (tmp_36.valid) {
			// \full_case: 1
			// \src: top.v:6637.9-6637.14|top.v:6637.5-6638.37
			// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procmux$3810
			memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory.update(tmp_36.index, (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2315__o ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q.curr : value<32>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_6638_24_2226__EN_5b_31_3a_0_5d__24_2252_5b_0_5d_.repeat<32>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.list write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:5982.9-5982.19|top.v:5982.5-5983.37
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3921
		auto tmp_37 = memory_index((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<61>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<66,62>()).val() : value<9>{0u}), 0, 512);
		CXXRTL_ASSERT(tmp_37.valid && "out of bounds write");
		if (tmp_37.valid) {
			// \full_case: 1
			// \src: top.v:5982.9-5982.19|top.v:5982.5-5983.37
			// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3918
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_list.update(tmp_37.index, (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<61>().val() ? p_unity__link__inst_2e_core__inst_2e_memory__word.curr.slice<7,0>().val() : value<8>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_list_24_top_2e_v_3a_5983_24_1585__EN_5b_7_3a_0_5d__24_2043_5b_0_5d_.repeat<8>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.divisors write port 0
	if (posedge_p_clk) {
		auto tmp_38 = memory_index(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5945_24_1567__ADDR_5b_3_3a_0_5d__24_2023, 0, 16);
		CXXRTL_ASSERT(tmp_38.valid && "out of bounds write");
		if (tmp_38.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4410 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5057$1737
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors.update(tmp_38.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4376__o ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<49>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<72,57>().val() : value<16>{0u}) : value<16>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5945_24_1567__EN_5b_13_3a_0_5d__24_2025_5b_0_5d_.repeat<16>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.counters write port 0
	if (posedge_p_clk) {
		// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4404 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:329$66
		auto tmp_39 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6719__o ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr) : value<4>{0u}), 0, 16);
		CXXRTL_ASSERT(tmp_39.valid && "out of bounds write");
		if (tmp_39.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4401 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:335$68 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:337$69 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$sub$top.v:339$70
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters.update(tmp_39.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6719__o ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor.curr : sub_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter.curr, value<1>{0x1u})) : value<16>{0x1u}) : value<16>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_counters_24_top_2e_v_3a_636_24_34__EN_5b_15_3a_0_5d__24_175_5b_0_5d_.repeat<16>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.losses write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:666.9-666.15|top.v:666.5-667.40
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4395
		auto tmp_40 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr : value<4>{0u}), 0, 16);
		CXXRTL_ASSERT(tmp_40.valid && "out of bounds write");
		if (tmp_40.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4392 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:343$72 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4338 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4343 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4348 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4353 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4358 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$add$top.v:341$71
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses.update(tmp_40.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due ? ((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4339__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<14>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4346__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<13>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4347__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<12>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4340__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<11>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<10>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4346__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4347__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<8>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4341__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<7>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<6>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4346__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4347__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<4>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4342__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<2>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4346__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<1>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4347__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<0>().val() : value<1>{0u})))) : value<1>{0u})))) ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__losses.curr, value<1>{0x1u}) : value<8>{0u}) : value<8>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_losses_24_top_2e_v_3a_667_24_51__EN_5b_7_3a_0_5d__24_186_5b_0_5d_.repeat<8>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.last write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:5992.9-5992.18|top.v:5992.5-5993.41
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3912
		auto tmp_41 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4222__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4936__q.curr.slice<4,0>()).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4111__o).val() : value<10>{0u}), 0, 1024);
		CXXRTL_ASSERT(tmp_41.valid && "out of bounds write");
		if (tmp_41.valid) {
			// \full_case: 1
			// \src: top.v:5992.9-5992.18|top.v:5992.5-5993.41
			// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3909
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last.update(tmp_41.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4222__o ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q.curr : value<32>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_last_24_top_2e_v_3a_5993_24_1586__EN_5b_31_3a_0_5d__24_2052_5b_0_5d_.repeat<32>().val(), 0);
		}
	}
	// cells $flatten\unity_link_inst.\with_fifo_fifo_port_inst.$procdff$4415 $flatten\unity_link_inst.\with_fifo_fifo_port_inst.$and$top.v:12219$3266 $flatten\unity_link_inst.\with_fifo_fifo_port_inst.$not$top.v:12217$3265
	if (posedge_p_clk) {
		p_out__flush.next = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_flush.curr, not_u<1>(p_rst));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4426 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12140$3242 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12086$3215 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$add$top.v:12084$3214
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n333__q.next = (p_rst ? value<8>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n333__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n333__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4425 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12142$3243 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12090$3217 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$add$top.v:12088$3216
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n334__q.next = (p_rst ? value<8>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n334__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n334__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4424 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12144$3244 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12134$3239 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$add$top.v:12112$3228 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12128$3236 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$sub$top.v:12122$3233
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n286__o ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<1>{0x1u}) : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o ? sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4423 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12146$3245 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12136$3240 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12126$3235 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12130$3237
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n286__o ? value<1>{0x1u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n276__o, p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4422 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12148$3246 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12138$3241 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12116$3230 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$eq$top.v:12114$3229 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12132$3238
	if (posedge_p_clk) {
		p_in__ready.next = (p_rst ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n286__o ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<8>{0xffu}) ? value<1>{0u} : p_in__ready.curr) : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o ? value<1>{0x1u} : p_in__ready.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4421 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12150$3247 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12104$3224
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n279__o ? p_in__lost.concat(p_in__data).val() : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4420 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12152$3248 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12106$3225 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12102$3223
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n341__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n279__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n341__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4419 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$3290
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n342__data.next = (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o ? i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_12178_24_3257__DATA : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n342__data.curr);
	}
	// cells $flatten\unity_link_inst.\wishbone_master_inst.$or$top.v:12265$3268 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6291$2150 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6289$2149 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$or$top.v:6287$2148
	p_wb__cyc = or_uu<1>(p_wb__stb.curr, and_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.curr, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q.curr), not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.curr)));
	// cells $flatten\unity_link_inst.\core_inst.\rx_register_inst.$procdff$4428 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:11978$3207 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:11974$3205
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_character__valid.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_fifo__out__ready ? p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr : p_unity__link__inst_2e_core__inst_2e_character__valid.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_register_inst.$procdff$4427 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:11976$3206 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:11972$3204 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12082$3213
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_character__in.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_fifo__out__ready ? (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n341__q.curr ? p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.curr : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n342__data.curr) : p_unity__link__inst_2e_core__inst_2e_character__in.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procdff$4429 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11932$3198 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11930$3197 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11928$3196 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11530$3097 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11534$3098 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11538$3099 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11542$3100 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11546$3101 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11551$3102 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11417$3077 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11415$3076 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11925$3195 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11897$3189 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11901$3190 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11892$3188 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11886$3186 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$sub$top.v:11880$3184 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11876$3183 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11888$3187 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11757$3160 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11906$3191 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11910$3192 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11914$3193 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11919$3194
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.next = (p_rst ? value<62>{0u,0x1020u} : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_advance ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<41>().val() ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n395__o ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<39>().val() ? value<4>{0x9u} : value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<38>().val() ? value<3>{0x7u} : value<3>{0u})).val())).concat(value<2>{0x3u}).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<61,56>().concat(value<1>{0u}).val()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n395__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n504__o)).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n395__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<53,46>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<7,0>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n395__o ? value<20>{0x40800u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<45,42>().concat(value<1>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<40,26>()).val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n395__o ? value<10>{0u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n503__o.concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<17>()).val())).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<15,8>()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n395__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<7,0>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<15,8>().val())).val() : (p_unity__link__inst_2e_core__inst_2e_character__valid.curr ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n545__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n767__o.slice<7,1>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<61,56>().concat(value<1>{0u}).val()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n545__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n767__o.slice<0>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n872__o.slice<8>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n545__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<53,46>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n872__o.slice<7,0>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n545__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n764__o.slice<29,23>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<45,42>().concat(value<2>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n535__o).val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n545__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n764__o.slice<22,0>().val() : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n775__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<38,26>().val() : (and_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n775__o ? value<1>{0u} : value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n875__o) ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<38>().val()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n875__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<37,26>().val() : sub_uu<12>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<37,26>().val(), value<1>{0x1u}))).val()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n869__o.slice<25,16>()).val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n545__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<15,0>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n869__o.slice<15,0>().val())).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<61,56>().concat(value<2>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<53,42>()).concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<40,0>()).val())) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procdff$4513 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1725$458 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1723$457 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4318 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1598$439 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$and$top.v:1592$437 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1594$438 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1627$446 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4311 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$sub$top.v:1620$444 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4304 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1584$434 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1580$433 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4628 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4297 $auto$opt_reduce.cc:131:opt_pmux$4726 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4290 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1492$414 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1588$435 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1612$443 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$gt$top.v:1604$441 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$add$top.v:1608$442 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4283 $auto$opt_reduce.cc:131:opt_pmux$4676 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4276 $auto$opt_reduce.cc:131:opt_pmux$4748 $auto$opt_reduce.cc:131:opt_pmux$4674 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1494$415
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.next = (p_rst ? value<26>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_advance ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4277__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4278__CMP).val()) ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<88>().val() ? value<1>{0x1u} : value<1>{0u}) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4279__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4280__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4281__CMP).val()) ? value<1>{0x1u} : value<1>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4281__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<14,13>().val() : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4277__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4278__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4279__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4280__CMP).val()) ? value<2>{0u} : value<2>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4277__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<88>().val() ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6249__o_5b_6_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<22,15>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4278__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<88>().val() ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<87,80>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<22,15>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4279__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<12,9>().val(), value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<12,9>().val())).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<12,9>()).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4280__CMP ? value<8>{0xdu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4281__CMP ? value<8>{0xau} : value<8>{0u})))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4278__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<92,91>().val() : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4277__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4279__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4280__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4281__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<14,13>().val() : value<2>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4277__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6331__o.slice<12,5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4278__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<88>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6372__o_5b_2_3a_0_5d_.slice<2>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6379__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6386__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6393__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6400__o_5b_2_3a_0_5d_.slice<2>()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6365__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6400__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6400__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val())).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<12,5>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4279__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<8,5>().concat(value<4>{0u}).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4280__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<12,5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4281__CMP ? value<8>{0u} : value<8>{0u})))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4277__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6331__o.slice<4,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4278__CMP ? value<2>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4279__CMP ? sub_uu<2>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<4,3>().val(), value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4280__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<4,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4281__CMP ? value<2>{0u} : value<2>{0u})))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4277__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6331__o.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4278__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<89>().val(), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<88>().val()) ? value<2>{0x1u}.concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<90>().val() ? value<1>{0x1u} : value<1>{0u})).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4279__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6245__o ? value<3>{0x4u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4280__CMP ? value<3>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4281__CMP ? value<3>{0x1u} : value<3>{0u})))))).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4524 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1104$359 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1050$332 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$add$top.v:1048$331
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6588__q.next = (p_rst ? value<8>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6500__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6588__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6588__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4523 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1106$360 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1054$334 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$add$top.v:1052$333
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6589__q.next = (p_rst ? value<8>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_n198__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6589__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6589__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4522 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1108$361 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1098$356 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$add$top.v:1076$345 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1092$353 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$sub$top.v:1086$350
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6541__o ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<1>{0x1u}) : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6549__o ? sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procdff$4430 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11015$3067 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11002$3064 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11005$3065 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11008$3066
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.next = (p_rst ? value<142>{0x10u,0u,0u,0u,0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2085__o.slice<141,127>().concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2087__o ? value<2>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2085__o.slice<126,125>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2085__o.slice<124,17>()).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2087__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2085__o.slice<16>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2085__o.slice<15,12>()).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2087__o ? value<12>{0x10u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2085__o.slice<11,0>().val())).val());
	}
	// \src: top.v:9090.3-9092.40
	// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procdff$4434
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_memory__word.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2166__data_5b_31_3a_0_5d_;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$procdff$4525 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:930$319 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:926$317 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:922$315 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:918$313
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_flush.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6604__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6607__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6609__o ? value<1>{0x1u} : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$procdff$4526 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:936$322 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:928$318 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:924$316 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:920$314
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6639__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6604__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6607__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6609__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6639__q.curr))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$procdff$4527 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:934$321
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark.next = (p_rst ? value<2>{0u} : p_unity__link__inst_2e_core__inst_2e_tx__entry.slice<9,8>().val());
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$procdff$4528 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:932$320
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left.next = (p_rst ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_n198__o);
	}
	// \src: top.v:3388.3-3389.28
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procdff$4511
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6179__q.next = p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__word.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4510 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3747$1534
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5059__q.next = (p_rst ? value<11>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5026__o);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4509 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3749$1535 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3729$1525 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5218$1786
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.next = (p_rst ? value<11>{0u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4330__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted) ? p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5026__o : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4508 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3751$1536
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5061__q.next = (p_rst ? value<11>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5030__o);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4507 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3743$1532 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$sub$top.v:3737$1529 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$sub$top.v:3735$1528
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__ring__room.next = (p_rst ? value<11>{0x400u} : sub_uu<11>(value<11>{0x400u}, sub_uu<11>(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5059__q.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5061__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4506 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3745$1533 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3741$1531 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ne$top.v:3739$1530
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available.next = (p_rst ? value<1>{0u} : (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5030__o) ? value<1>{0x1u} : value<1>{0u}));
	}
	// \src: top.v:3769.3-3771.37
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4505
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__word.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_5c_n5066__data_5b_31_3a_0_5d_;
	}
	// \src: top.v:9075.3-9076.28
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procdff$4435
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.next = p_unity__link__inst_2e_core__inst_2e_memory__word.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procdff$4436 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9070$2703 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3593 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8727$2643 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8814$2670 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8794$2664 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8782$2660 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8775$2658 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8772$2657 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8770$2656 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8829$2676 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8845$2680 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8860$2685 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8869$2688 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8866$2687 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3583 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7754$2362 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7752$2361 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7763$2364 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$sub$top.v:7759$2363 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3573 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3563 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3553 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3543 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8819$2672 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8800$2666 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8785$2661 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8766$2655 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$add$top.v:8763$2654 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$sub$top.v:8757$2652 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3533 $auto$opt_reduce.cc:131:opt_pmux$4706 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8848$2681 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8745$2649 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8738$2647 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7769$2366 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ge$top.v:7767$2365 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3523 $auto$opt_reduce.cc:131:opt_pmux$4704 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8730$2644 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3513 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3503 $auto$opt_reduce.cc:131:opt_pmux$4700 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8851$2682 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3493 $auto$opt_reduce.cc:131:opt_pmux$4698 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8855$2683 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3483 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8810$2669 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8824$2674 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3473
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.next = (p_rst ? value<75>{0xd2000u,0x8000000u,0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4695 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<74>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3159__o.slice<4>().val() : value<1>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed, p_unity__link__inst_2e_core__inst_2e_access__done) ? p_unity__link__inst_2e_core__inst_2e_access__failure.curr : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<73,70>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4697 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<73,70>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3159__o.slice<3,0>().val() : value<4>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3479__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3259__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<69,62>().concat(value<1>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<54,47>().concat(value<1>{0x1u}).val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3476__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3478__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3480__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3481__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<69,62>().concat(value<1>{0u}).val() : value<9>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3479__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3259__o ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<60,58>().val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3476__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3478__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3480__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3481__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<60,58>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3157__o.slice<4,2>().val() : value<3>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3245__o.slice<1>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4697 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<57>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3157__o.slice<1>().val() : value<1>{0u})))).concat((reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3478__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3479__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3480__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3481__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<56>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3245__o.slice<0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3476__CMP ? value<1>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<55>().val() ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<56>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3157__o.slice<0>().val() : value<1>{0u})))))).concat((ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.curr, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<141,134>().val()) ? value<1>{0x1u} : value<1>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3479__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3259__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<54,47>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3179__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<18>().val(), p_unity__link__inst_2e_core__inst_2e_access__granted) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3179__o : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<54,47>().val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3476__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3478__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3480__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3481__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<54,47>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP ? value<8>{0u} : value<8>{0u}))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__done ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<46,31>().val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2254__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<46,31>().val() : sub_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<46,39>().val(), value<1>{0x1u}).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<38,31>().val() : add_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<38,31>().val(), value<1>{0x1u}))).val())) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<46,31>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4697 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<46,31>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3156__o.slice<30,15>().val() : value<16>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4695 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<30,21>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3156__o.slice<14,5>().val() : value<10>{0u}))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4695 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<20>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3156__o.slice<4>().val() : value<1>{0u}))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4695 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19,16>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3156__o.slice<3,0>().val() : value<4>{0u}))).concat(not_u<1>(sub_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<24,17>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<10,3>().val()).slice<7>().val())).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<24,17>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<10,3>().val()) ? value<1>{0x1u} : value<1>{0u})).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4695 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<13,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3154__o.slice<13,3>().val() : value<11>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3154__o.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<55>().val() ? value<3>{0x3u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3476__CMP ? value<3>{0x3u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__done ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? value<3>{0x7u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2254__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19,16>().val(), value<3>{0x7u}) ? value<3>{0u} : value<3>{0x7u}) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val()))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3478__CMP ? (p_unity__link__inst_2e_core__inst_2e_group__done ? value<3>{0x5u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3479__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3259__o ? value<3>{0x6u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3480__CMP ? (p_unity__link__inst_2e_core__inst_2e_group__done ? value<3>{0x7u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3481__CMP ? (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_answer__taken, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<22>().val()) ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val()) : value<3>{0u}))))))))).val());
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4445 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6611$2239
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3437__q.next = (p_rst ? value<9>{0u} : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3404__o);
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4444 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6613$2240 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6593$2230 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7560$2298
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.next = (p_rst ? value<9>{0u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2326__o, p_unity__link__inst_2e_core__inst_2e_answer__taken) ? p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3404__o : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4443 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6615$2241 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6597$2232 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2322$733 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2320$732 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$add$top.v:6595$2231
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3439__q.next = (p_rst ? value<9>{0u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word, not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<78>().val())) ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3439__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3439__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4442 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6607$2237 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$sub$top.v:6601$2234 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$sub$top.v:6599$2233
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.next = (p_rst ? value<9>{0x100u} : sub_uu<9>(value<9>{0x100u}, sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3437__q.curr, p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3439__q.curr)));
	}
	// \src: top.v:6633.3-6635.37
	// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4440
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3444__data_5b_31_3a_0_5d_;
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4458 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6482$2206 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3846 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6319$2164 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6343$2176 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6333$2171
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.next = (p_rst ? value<2>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o ? value<2>{0x1u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3818__CMP ? (p_unity__link__inst_2e_bus__done ? value<2>{0x2u} : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3541__o ? value<2>{0x2u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3819__CMP ? value<2>{0u} : value<2>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4457 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6484$2207 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3841 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6299$2154 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6293$2151
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.next = (p_rst ? value<1>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4679 ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr)) : value<1>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4456 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6486$2208 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3836 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6295$2152 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5168$1771 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5166$1770 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6351$2180 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6357$2183
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample ? (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4252__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4922__q.curr.slice<13,6>().val()) ? value<1>{0x1u} : value<1>{0u}) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3818__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3819__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3562__o) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.curr) : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4455 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6488$2209 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3831 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6301$2155 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6359$2184 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6353$2181
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? p_unity__link__inst_2e_core__inst_2e_access__more : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3818__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3819__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3562__o ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q.curr : value<1>{0u}) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q.curr) : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4454 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6490$2210 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3826 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6303$2156 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6297$2153 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7534$2287 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6361$2185 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6355$2182
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__more, or_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__write, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked)) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3818__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3819__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3562__o ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr : value<1>{0u}) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr) : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4453 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6492$2211 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3821 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6345$2177 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6335$2172
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3818__CMP ? (p_unity__link__inst_2e_bus__done ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.curr : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3541__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3819__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.curr : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4452 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6494$2212 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3816 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$sub$top.v:6323$2166
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3650__q.next = (p_rst ? value<11>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP ? value<11>{0x3ffu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3818__CMP ? sub_uu<11>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3650__q.curr, value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3819__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3650__q.curr : value<11>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4451 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6470$2200 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3876 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6337$2173 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6325$2167 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6329$2169
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_access__failure.next = (p_rst ? value<4>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3818__CMP ? (p_unity__link__inst_2e_bus__done ? value<1>{0u}.concat((p_wb__err ? value<3>{0x4u} : value<3>{0u})).val() : value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3541__o ? value<3>{0x5u} : value<3>{0u})).val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4687 ? p_unity__link__inst_2e_core__inst_2e_access__failure.curr : value<4>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4450 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6472$2201 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3871 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6339$2174
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q.next = (p_rst ? value<32>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3818__CMP ? (p_unity__link__inst_2e_bus__done ? p_wb__dat__i : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4687 ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q.curr : value<32>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4449 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6474$2202 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3866 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6311$2160 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6341$2175 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6331$2170
	if (posedge_p_clk) {
		p_wb__stb.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o ? value<1>{0x1u} : p_wb__stb.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3818__CMP ? (p_unity__link__inst_2e_bus__done ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3541__o ? value<1>{0u} : p_wb__stb.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3819__CMP ? p_wb__stb.curr : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4448 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6476$2203 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3861 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6313$2161 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6307$2158
	if (posedge_p_clk) {
		p_wb__we.next = (p_rst ? value<1>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4679 ? p_wb__we.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o ? and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__granted, p_unity__link__inst_2e_core__inst_2e_access__write) : p_wb__we.curr) : value<1>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4447 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6478$2204 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3856 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6315$2162 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6309$2159
	if (posedge_p_clk) {
		p_wb__adr.next = (p_rst ? value<8>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4679 ? p_wb__adr.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample__address.curr : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<38,31>().val()) : p_wb__adr.curr) : value<8>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4446 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6480$2205 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3851 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6317$2163 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7538$2288 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7470$2263 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7468$2262 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7548$2293 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7546$2292 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7544$2291 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7542$2290 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7540$2289
	if (posedge_p_clk) {
		p_wb__dat__o.next = (p_rst ? value<32>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4679 ? p_wb__dat__o.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o ? ((or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2214__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2217__o) ? value<1>{0x1u} : value<1>{0u}) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.curr : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked ? or_uu<32>(and_uu<32>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q.curr, not_u<32>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.curr)), and_uu<32>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<104,73>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.curr)) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<104,73>().val())) : p_wb__dat__o.curr) : value<32>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4521 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1110$362 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1100$357 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1090$352 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1094$354
	if (posedge_p_clk) {
		p_out__valid.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6541__o ? value<1>{0x1u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6531__o, p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6549__o) ? value<1>{0u} : p_out__valid.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4520 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1112$363 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1102$358 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1080$347 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$eq$top.v:1078$346 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1096$355
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_sent__ready.next = (p_rst ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6541__o ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<8>{0xffu}) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_sent__ready.curr) : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6549__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_sent__ready.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4519 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1114$364 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1068$341
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.next = (p_rst ? value<10>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6534__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6493__q.curr.slice<24,15>().val() : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4518 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1116$365 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1070$342 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1066$340
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6596__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6534__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_n198__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6596__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procdff$4512 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3383$998 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3381$997 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4217 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2687$850 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2903$916 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2989$936 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3079$956 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3167$977 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4208 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4199 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4190 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2859$904 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4181 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4172 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2870$906 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4163 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3086$959 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$sub$top.v:3068$953 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2469$771 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7714$2349 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7712$2348 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7706$2346 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7704$2345 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7710$2347 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3378$996 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3376$995 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4154 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2473$772 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4145 $auto$opt_reduce.cc:131:opt_pmux$4754 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2991$937 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2905$917 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2690$851 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4136 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4127 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3091$961 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4118 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2566$807 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4272 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4273_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4274_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4264 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4265_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4266_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4267_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4268_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4269_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4270_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2848$902 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:2840$900 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:2844$901 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2944$926 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:2936$924 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:2940$925 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3030$946 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:3022$944 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:3026$945 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3130$970 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:3122$968 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:3126$969 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4109 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4100 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2692$852 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2894$912 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2907$918 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2986$935 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2993$938 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3081$957 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3169$978 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4091 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2477$774 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7748$2360 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7736$2355 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7746$2359 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:7742$2357 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2452$768 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2435$764
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.next = (p_rst ? value<93>{0u,0u,0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance ? (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4657 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<92,90>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? (p_unity__link__inst_2e_core__inst_2e_answer__taken ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<13,12>().val(), value<1>{0x1u}) ? value<2>{0x2u} : value<1>{0u}.concat((reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<13,12>().val()) ? value<1>{0x1u} : value<1>{0u})).val()).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<21>()).val() : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5113__o ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6179__q.curr.slice<4>().val() ? value<2>{0x2u} : value<2>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6179__q.curr.slice<5>()).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<92,90>().val())) : value<3>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4093__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5509__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5559__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4094__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5559__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5550__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5144__o) ? value<1>{0x1u} : value<1>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4096__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5542__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5144__o) ? value<1>{0x1u} : value<1>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4097__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6019__o ? value<1>{0x1u} : value<1>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4098__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5144__o ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})))))))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4657 ? value<1>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? value<1>{0u} : value<1>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<87,80>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4093__CMP ? value<2>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<8>()).concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<7>().val() ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5297__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5293__o).val(), value<1>{0x1u}) ? value<5>{0x18u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5297__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5293__o).val(), value<2>{0x2u}) ? value<5>{0xeu} : value<5>{0x10u})) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5383__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5374__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5365__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5356__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5347__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5326__o).val(), value<1>{0x1u}) ? value<5>{0x12u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5383__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5374__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5365__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5356__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5347__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5326__o).val(), value<2>{0x2u}) ? value<5>{0x17u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5383__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5374__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5365__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5356__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5347__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5326__o).val(), value<3>{0x4u}) ? value<5>{0x9u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5383__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5374__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5365__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5356__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5347__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5326__o).val(), value<4>{0x8u}) ? value<5>{0x8u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5383__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5374__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5365__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5356__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5347__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5326__o).val(), value<5>{0x10u}) ? value<5>{0x11u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5383__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5374__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5365__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5356__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5347__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5326__o).val(), value<6>{0x20u}) ? value<5>{0xbu} : value<5>{0x7u})))))))).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4094__CMP ? value<2>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5507__o).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5758__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5758__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5758__o).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4096__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5861__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5861__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5861__o).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4097__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5954__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5954__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5954__o).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4098__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6058__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6058__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6058__o).val()) : value<8>{0u})))))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4097__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5144__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<79>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4731 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<79>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5278__o.slice<1>().val() : value<1>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4657 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<78>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5278__o.slice<0>().val() : value<1>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4098__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5798__o : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4096__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4097__CMP).val()) ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5144__o ? value<6>{0x7u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5798__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5144__o ? value<3>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5549__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5798__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4094__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5558__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4093__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5509__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<77,72>().val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5558__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<77,72>().val() : value<6>{0u}))))))).concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<78>().val() ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6179__q.curr : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4743 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<67,40>().concat(value<4>{0u}).val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4691 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<71,40>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? (p_unity__link__inst_2e_core__inst_2e_answer__taken ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<71,40>().val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5259__o.slice<40,9>().val()) : value<32>{0u}))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4097__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5144__o ? sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<39,31>().val(), value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<39,31>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4731 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<39,31>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? (p_unity__link__inst_2e_core__inst_2e_answer__taken ? value<1>{0u}.concat((and_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19,18>().val()), and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<74>().val()), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2398__o)) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<141,134>().val() : value<8>{0u})).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5259__o.slice<8,0>().val()) : value<9>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5271__o.slice<21,14>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4691 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<30,23>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4743 ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5183__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<26,23>().concat(value<4>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<30,23>().val()) : value<8>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4657 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<22,19>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5271__o.slice<13,10>().val() : value<4>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5271__o.slice<9,2>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4691 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<18,11>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4743 ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5160__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<14,11>().concat(value<4>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<18,11>().val()) : value<8>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4657 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<10,9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5271__o.slice<1,0>().val() : value<2>{0u}))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4657 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<8,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5268__o.slice<8,3>().val() : value<6>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5268__o.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4093__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5509__o ? value<3>{0x2u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5557__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4094__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5557__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5144__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5548__o : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4096__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5144__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5546__o : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4097__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6019__o ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4098__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5144__o ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr.slice<2,0>().val()) : value<3>{0u})))))))).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178__q.curr));
	}
	// \src: top.v:662.3-664.40
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4534
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6998__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6998__data_5b_7_3a_0_5d_;
	}
	// \src: top.v:659.3-661.37
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4535
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6996__data_5b_7_3a_0_5d_;
	}
	// \src: top.v:631.3-633.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4539
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6992__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6992__data_5b_15_3a_0_5d_;
	}
	// \src: top.v:603.3-605.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4543
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6988__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6988__data_5b_15_3a_0_5d_;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4544 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:540$144 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:537$143 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:530$141 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:528$140 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:535$142 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:526$139 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:519$137 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:517$136 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:524$138 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:515$135 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:508$133 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:506$132 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:513$134 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:504$131 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:497$129 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:495$128 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:502$130 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:493$127 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:486$125 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:484$124 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:491$126 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:482$123 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:475$121 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:473$120 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:480$122 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:471$119 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:464$117 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:462$116 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:469$118 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:460$115 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:453$113 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:451$112 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:458$114 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:449$111 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:442$109 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:440$108 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:447$110 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:438$107 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:431$105 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:429$104 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:436$106 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:427$103 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:420$101 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:418$100 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:425$102 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:416$99 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:409$97 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:407$96 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:414$98 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:405$95 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:398$93 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:396$92 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:403$94 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:394$91 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:387$89 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:385$88 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:392$90 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:383$87 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:376$85 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:374$84 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:381$86 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:372$83 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:365$81 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:363$80 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:370$82
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.next = (p_rst ? value<16>{0u} : (and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xfu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<15>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<15>().val())).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xeu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<14>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<14>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xdu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<13>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<13>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xcu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<12>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<12>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xbu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<11>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<11>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xau}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<10>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<10>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0x9u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<9>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<9>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0x8u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<8>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<8>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<3>{0x7u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<7>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<7>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<3>{0x6u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<6>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<6>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<3>{0x5u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<5>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<5>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<3>{0x4u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<4>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<4>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<2>{0x3u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<3>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<3>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<2>{0x2u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<2>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<2>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<1>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<1>().val()))).concat((and_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<0>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<0>().val()))).val());
	}
	// \src: top.v:578.3-579.28
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4545
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__losses.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6998__data.curr;
	}
	// \src: top.v:575.3-576.29
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4546
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6992__data.curr;
	}
	// \src: top.v:572.3-573.29
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4547
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6988__data.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4548 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:552$150
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.next = (p_rst ? value<4>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6975__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4549 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:550$149
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.next = (p_rst ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6974__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4550 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:548$148
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6975__q.next = (p_rst ? value<4>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6973__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4551 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:546$147
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6974__q.next = (p_rst ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6972__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4552 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:544$146 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:361$79 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:357$77 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$add$top.v:349$73
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6973__q.next = (p_rst ? value<4>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick.curr ? value<4>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6972__q.curr ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6973__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6973__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4553 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:542$145 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:359$78 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:353$75 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:355$76 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:351$74
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6972__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick.curr ? value<1>{0x1u} : (and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6973__q.curr, value<4>{0xfu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6972__q.curr) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6972__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$procdff$4529 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$ternary$top.v:857$303 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$ternary$top.v:853$301
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6647__o ? value<1>{0x1u} : value<1>{0u}));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$procdff$4530 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$ternary$top.v:859$304 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$ternary$top.v:855$302 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$sub$top.v:849$299
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6661__q.next = (p_rst ? value<6>{0x31u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6647__o ? value<6>{0x31u} : sub_uu<6>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6661__q.curr, value<1>{0x1u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4501 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4658$1594
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3695__q.next = (p_rst ? value<16>{0xffffu} : p_trigger);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4500 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4660$1595
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3696__q.next = (p_rst ? value<16>{0xffffu} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3695__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4499 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4662$1596
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3697__q.next = (p_rst ? value<16>{0xffffu} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3696__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4498 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5827$1985 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4062 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5403$1861 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5395$1857 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4078 $auto$opt_reduce.cc:131:opt_pmux$4672 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5421$1870 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5419$1869 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5417$1868 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5437$1878 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5433$1876 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5465$1892 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5461$1890 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5459$1889 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5457$1888 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5477$1898 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5651$1969
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.next = (p_rst ? value<4>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3858__o ? value<4>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3843__o ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4075__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4076__CMP).val()) ? value<4>{0x9u} : value<4>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP ? value<4>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP ? (and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<60,58>().val(), value<2>{0x3u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4229__o) ? value<4>{0x8u} : value<4>{0x3u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP ? value<4>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP ? value<4>{0x5u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4211__o ? value<3>{0x3u}.concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room.curr ? value<1>{0u} : value<1>{0x1u})).val() : value<4>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3497__o ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3562__o ? value<4>{0x7u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4596__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4922__q.curr.slice<13,6>().val()) ? value<4>{0x7u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr)) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4229__o ? value<4>{0x9u} : value<4>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3951__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out ? value<4>{0x9u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3952__CMP ? value<4>{0u} : value<4>{0u})))))))))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4497 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5829$1986 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4050 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5405$1862 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5286$1818 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5397$1858
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4919__q.next = (p_rst ? value<2>{0x2u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4669 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4919__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3858__o ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4930__q.curr ? value<1>{0u} : value<1>{0x1u})).val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3843__o ? value<2>{0x2u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4919__q.curr)) : value<2>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4496 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5831$1987 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4038 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5407$1863 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5399$1859
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.next = (p_rst ? value<4>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4669 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3858__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3843__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().val() : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4920__q.curr)) : value<4>{0u})));
	}
	// \src: top.v:5858.3-5859.30
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4495
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4922__q.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4948__data.curr;
	}
	// \src: top.v:5861.3-5862.27
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4494
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4952__data.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4493 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5833$1988 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4026 $auto$opt_reduce.cc:131:opt_pmux$4666 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5653$1970 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5647$1967 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5645$1966 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5409$1864 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5401$1860 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4074 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5376$1853 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5374$1852 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5371$1851 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5369$1850 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5366$1849 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5363$1848 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5361$1847 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5358$1846 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5356$1845 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5353$1844 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5351$1843 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5348$1842 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5346$1841 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5343$1840 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5341$1839 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5338$1838 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5336$1837 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5333$1836 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5331$1835 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5328$1834 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5326$1833 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5323$1832 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5321$1831 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5318$1830 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5316$1829 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5313$1828 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5311$1827 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5308$1826 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5306$1825 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5303$1824 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5301$1823 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5298$1822 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5296$1821 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5294$1820
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.next = (p_rst ? value<16>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3951__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4368__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr : or_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4637__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4644__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4650__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4656__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4662__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4668__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4674__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4680__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4686__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4692__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4698__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4704__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4710__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4716__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4722__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4727__o).val())) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3952__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3858__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3843__o ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4075__CMP ? value<16>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4076__CMP ? and_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr, not_u<16>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().val(), value<4>{0xfu}) ? value<1>{0x1u} : value<1>{0u}).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().val(), value<4>{0xeu}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().val(), value<4>{0xdu}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().val(), value<4>{0xcu}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().val(), value<4>{0xbu}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().val(), value<4>{0xau}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().val(), value<4>{0x8u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().val(), value<3>{0x7u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().val(), value<3>{0x6u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().val(), value<3>{0x5u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().val(), value<3>{0x4u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().val(), value<2>{0x3u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().val(), value<2>{0x2u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().val(), value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u})).concat((logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,41>().val()) ? value<1>{0x1u} : value<1>{0u})).val())) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr)) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr)) : value<16>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4492 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5835$1989 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4014 $auto$opt_reduce.cc:131:opt_pmux$4664 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5649$1968 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5655$1971 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5563$1933
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.next = (p_rst ? value<16>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3951__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4368__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out) ? or_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4637__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4644__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4650__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4656__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4662__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4668__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4674__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4680__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4686__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4692__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4698__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4704__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4710__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4716__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4722__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4727__o).val()) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3952__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr : value<16>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4491 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4656$1593 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4654$1592 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4652$1591 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5041$1736 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5036$1734 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5031$1732 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5026$1730 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5021$1728 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5016$1726 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5011$1724 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5006$1722 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5001$1720 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4996$1718 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4991$1716 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4986$1714 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4981$1712 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4976$1710 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4971$1708 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4966$1706 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4961$1704 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:4650$1590 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4648$1589 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4646$1588 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4644$1587
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__trigger.next = (p_rst ? value<16>{0u} : and_uu<16>(or_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__trigger.curr, and_uu<16>(and_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3696__q.curr, not_u<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3697__q.curr)), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr)), not_u<16>(or_uu<16>((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3867__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u}).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3873__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3878__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3883__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3888__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3893__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3898__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3903__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3908__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3913__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3918__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3923__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3933__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3938__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3943__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).val(), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3946__o))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4490 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4837$1650 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4831$1647 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4821$1644 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4811$1641 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4801$1638 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4791$1635 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4781$1632 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4771$1629 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4761$1626 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4751$1623 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4741$1620 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4731$1617 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4721$1614 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4711$1611 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4701$1608 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4691$1605 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4681$1602
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4928__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<0>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<1>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<2>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<3>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<4>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<5>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<6>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<7>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<8>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<9>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<10>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<11>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<12>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<13>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<14>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<15>().val() ? value<1>{0x1u} : value<1>{0u})))))))))))))))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4489 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4839$1651 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4833$1648 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4823$1645 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4813$1642 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4803$1639 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4793$1636 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4783$1633 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4773$1630 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4763$1627 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4753$1624 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4743$1621 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4733$1618 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4723$1615 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4713$1612 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4703$1609 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4693$1606 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4683$1603
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.next = (p_rst ? value<4>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<0>().val() ? value<4>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<1>().val() ? value<4>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<2>().val() ? value<4>{0x2u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<3>().val() ? value<4>{0x3u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<4>().val() ? value<4>{0x4u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<5>().val() ? value<4>{0x5u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<6>().val() ? value<4>{0x6u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<7>().val() ? value<4>{0x7u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<8>().val() ? value<4>{0x8u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<9>().val() ? value<4>{0x9u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<10>().val() ? value<4>{0xau} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<11>().val() ? value<4>{0xbu} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<12>().val() ? value<4>{0xcu} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<13>().val() ? value<4>{0xdu} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<14>().val() ? value<4>{0xeu} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<15>().val() ? value<4>{0xfu} : value<4>{0u})))))))))))))))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4488 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4841$1652 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4835$1649 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4825$1646 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4815$1643 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4805$1640 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4795$1637 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4785$1634 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4775$1631 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4765$1628 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4755$1625 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4745$1622 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4735$1619 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4725$1616 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4715$1613 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4705$1610 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4695$1607 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4685$1604
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4930__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<0>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<0>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<1>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<1>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<2>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<2>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<3>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<3>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<4>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<4>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<5>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<5>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<6>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<6>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<7>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<7>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<8>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<8>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<9>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<9>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<10>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<10>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<11>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<11>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<12>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<12>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<13>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<13>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<14>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<14>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<15>().val() : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4930__q.curr)))))))))))))))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4487 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5837$1990 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4002 $auto$opt_reduce.cc:131:opt_pmux$4662
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4931__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3952__CMP ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP ? value<1>{0x1u} : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3951__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4931__q.curr : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4486 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5839$1991 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3990 $auto$opt_reduce.cc:131:opt_pmux$4660
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost__kept.next = (p_rst ? value<8>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost.curr : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3951__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3952__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost__kept.curr : value<8>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4485 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5126$1752 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5122$1750
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4933__q.next = (p_rst ? value<32>{0u} : add_uu<32>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4933__q.curr, value<1>{0x1u}));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4484 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5120$1749 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5116$1747 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5118$1748
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4934__q.next = (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4919__q.curr) ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<7,0>().val(), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost__kept.curr) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<7,0>().val());
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4483 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5841$1992 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3978 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5445$1882
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.next = (p_rst ? value<8>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4252__o : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4653 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP ? value<8>{0u} : value<8>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4482 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5843$1993 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3966 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5467$1893
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4936__q.next = (p_rst ? value<8>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3497__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4596__o : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4936__q.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4653 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4936__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP ? value<8>{0u} : value<8>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4481 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5845$1994 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3954 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5451$1885 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5469$1894 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5449$1884
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP ? (and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__word.curr), p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3497__o) ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4653 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP ? value<1>{0u} : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4480 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5847$1995 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3942 $auto$opt_reduce.cc:131:opt_pmux$4650 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5463$1891 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5471$1895 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5439$1879 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5435$1877
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3562__o, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3497__o) ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4211__o ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room.curr ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr : value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3951__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3952__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP ? value<1>{0u} : value<1>{0u})))));
	}
	// \src: top.v:5906.3-5907.26
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4479
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__word.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__read.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4478 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5108$1744 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5106$1743 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5100$1742
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4942__q.next = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4922__q.curr.slice<3>().val() ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4922__q.curr.slice<13,6>().val(), value<2>{0x2u}) : add_uu<9>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4922__q.curr.slice<13,6>().val(), value<1>{0x1u}));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4477 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5114$1746 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ge$top.v:5112$1745
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room.next = (ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__ring__room.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4942__q.curr) ? value<1>{0x1u} : value<1>{0u});
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4476 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5096$1741 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5094$1740 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$lt$top.v:5085$1739 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3880 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3881_CMP0 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3882_CMP0 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3883_CMP0 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3884_CMP0 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3885 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3890 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3895 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3900
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_group__is__set.next = (p_rst ? value<1>{0u} : (lt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,41>().val(), value<5>{0x10u}) ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,43>().val(), value<2>{0x3u}) ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3886__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3887__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<14>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3888__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<13>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3889__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<12>().val() : value<1>{0u})))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,43>().val(), value<2>{0x2u}) ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3886__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<11>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3887__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<10>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3888__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3889__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<8>().val() : value<1>{0u})))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,43>().val(), value<1>{0x1u}) ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3886__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<7>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3887__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<6>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3888__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3889__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<4>().val() : value<1>{0u})))) : (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,43>().val()) ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3886__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3887__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<2>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3888__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<1>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3889__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<0>().val() : value<1>{0u})))) : value<1>{0u})))) : value<1>{0u}));
	}
	// \src: top.v:5918.3-5919.29
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4475
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample__address.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_address__read.curr;
	}
	// \src: top.v:5940.3-5942.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4474
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4948__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4948__data_5b_13_3a_0_5d_;
	}
	// \src: top.v:5968.3-5970.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4470
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4952__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4952__data_5b_9_3a_0_5d_;
	}
	// \src: top.v:5978.3-5980.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4466
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_address__read.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4955__data_5b_7_3a_0_5d_;
	}
	// \src: top.v:5988.3-5990.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4462
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__read.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4958__data_5b_31_3a_0_5d_;
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4517 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$4336
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6597__data.next = (p_unity__link__inst_2e_core__inst_2e_n198__o ? i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_1142_24_374__DATA : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6597__data.curr);
	}
	// connection
	p_out__data = p_unity__link__inst_2e_core__inst_2e_tx__entry.slice<7,0>().val();
	// connection
	p_wb__sel = value<4>{0xfu};
	return converged;
}

} // namespace cxxrtl_design

