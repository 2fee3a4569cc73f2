// a89cdf72b59eae95 names what this was made from: unity_link_fifo in its configuration 'ft232h', by GHDL and Yosys 0.70.0.
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
// \src: top.v:13226.1-13319.10
struct p_unity__link__fifo : public module {
	// \hdlname: unity_link_inst core_inst request_executor_inst memory_kept
	// \src: top.v:6695.15-6695.26
	wire<32> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2144_q
	// \src: top.v:9707.15-9707.22
	wire<146> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q;
	// \hdlname: unity_link_inst core_inst request_executor_inst ring_room
	// \src: top.v:6652.17-6652.26
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
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst committed
	// \src: top.v:3689.15-3689.24
	wire<11> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst n5055_q
	// \src: top.v:3708.14-3708.21
	wire<11> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5055__q;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst n5057_q
	// \src: top.v:3710.14-3710.21
	wire<11> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5057__q;
	// \hdlname: unity_link_inst core_inst response_ring_inst n3439_q
	// \src: top.v:6562.13-6562.20
	wire<9> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3439__q;
	// \hdlname: unity_link_inst core_inst response_ring_inst n3437_q
	// \src: top.v:6560.13-6560.20
	wire<9> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3437__q;
	// \hdlname: unity_link_inst core_inst response_ring_inst committed
	// \src: top.v:6541.14-6541.23
	wire<9> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6491_q
	// \src: top.v:1330.14-1330.21
	wire<26> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3362_q
	// \src: top.v:7391.14-7391.21
	wire<83> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst tick_inst n6659_q
	// \src: top.v:843.13-843.20
	wire<6> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6659__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3697_q
	// \src: top.v:3887.14-3887.21
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3697__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3696_q
	// \src: top.v:3886.14-3886.21
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3696__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3695_q
	// \src: top.v:3885.14-3885.21
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3695__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst group_state
	// \src: top.v:3819.14-3819.25
	wire<10> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst is_set
	// \src: top.v:3828.15-3828.21
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst due_by_timer
	// \src: top.v:3829.15-3829.27
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst due_by_trigger
	// \src: top.v:3830.15-3830.29
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__trigger;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst tick
	// \src: top.v:3839.8-3839.12
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst lost
	// \src: top.v:3845.14-3845.18
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst lost_kept
	// \src: top.v:3846.14-3846.23
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost__kept;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst asked
	// \src: top.v:3849.14-3849.19
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst changed
	// \src: top.v:3851.8-3851.15
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst failed
	// \src: top.v:3852.8-3852.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst last_read
	// \src: top.v:3853.15-3853.24
	wire<32> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__read;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst last_word
	// \src: top.v:3854.15-3854.24
	wire<32> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__word;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst address_read
	// \src: top.v:3855.14-3855.26
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_address__read;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst enough_room
	// \src: top.v:3858.8-3858.19
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3652_q
	// \src: top.v:6203.14-6203.21
	wire<32> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3650_q
	// \src: top.v:6201.14-6201.21
	wire<11> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3650__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3649_q
	// \src: top.v:6200.7-6200.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3647_q
	// \src: top.v:6198.7-6198.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3646_q
	// \src: top.v:6197.7-6197.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3644_q
	// \src: top.v:6195.13-6195.20
	wire<2> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst exclusive
	// \src: top.v:6103.8-6103.17
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive;
	// \hdlname: unity_link_inst core_inst bus_master_inst for_sample
	// \src: top.v:6100.8-6100.18
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample;
	// \hdlname: unity_link_inst core_inst bus_master_inst sample_address
	// \src: top.v:6084.17-6084.31
	wire<8> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample__address;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6177_q
	// \src: top.v:2250.14-2250.21
	wire<32> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6177__q;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6176_q
	// \src: top.v:2249.14-2249.21
	wire<97> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q;
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
	// \src: top.v:11347.14-11347.20
	wire<62> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6595_data
	// \src: top.v:1016.13-1016.23
	wire<10> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6595__data;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6594_q
	// \src: top.v:1015.7-1015.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6594__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6587_q
	// \src: top.v:1010.13-1010.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6587__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6586_q
	// \src: top.v:1009.13-1009.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6586__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst bypass
	// \src: top.v:969.14-969.20
	wire<10> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst count
	// \src: top.v:963.14-963.19
	wire<9> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst n6637_q
	// \src: top.v:896.7-896.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6637__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst count
	// \src: top.v:11992.14-11992.19
	wire<9> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst bypass
	// \src: top.v:11998.14-11998.20
	wire<9> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n333_q
	// \src: top.v:12038.13-12038.19
	wire<8> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n333__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n334_q
	// \src: top.v:12039.13-12039.19
	wire<8> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n334__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n341_q
	// \src: top.v:12044.7-12044.13
	wire<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n341__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n342_data
	// \src: top.v:12045.13-12045.22
	wire<9> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n342__data;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst its_mark
	// \src: top.v:876.14-876.22
	wire<2> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst has_left
	// \src: top.v:875.8-875.16
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6970_q
	// \src: top.v:178.7-178.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6970__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6971_q
	// \src: top.v:179.13-179.20
	wire<4> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6971__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6972_q
	// \src: top.v:180.7-180.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6972__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6973_q
	// \src: top.v:181.13-181.20
	wire<4> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6973__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6986_data
	// \src: top.v:188.14-188.24
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6986__data;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6990_data
	// \src: top.v:189.14-189.24
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6990__data;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6996_data
	// \src: top.v:191.13-191.23
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6996__data;
	// \hdlname: unity_link_inst core_inst with_groups_ring_room
	// \src: top.v:12468.15-12468.36
	wire<11> p_unity__link__inst_2e_core__inst_2e_with__groups__ring__room;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4948_data
	// \src: top.v:4467.13-4467.23
	wire<10> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4948__data;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4944_data
	// \src: top.v:4466.14-4466.24
	wire<14> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4944__data;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4938_q
	// \src: top.v:4462.13-4462.20
	wire<9> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4938__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4932_q
	// \src: top.v:4458.13-4458.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4932__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4930_q
	// \src: top.v:4456.13-4456.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4930__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4929_q
	// \src: top.v:4455.14-4455.21
	wire<32> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4927_q
	// \src: top.v:4453.7-4453.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4927__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4926_q
	// \src: top.v:4452.7-4452.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4926__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4925_q
	// \src: top.v:4451.13-4451.20
	wire<4> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4924_q
	// \src: top.v:4450.7-4450.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4924__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4921_q
	// \src: top.v:4447.14-4447.21
	wire<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4918_q
	// \src: top.v:4445.14-4445.21
	wire<14> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4916_q
	// \src: top.v:4444.13-4444.20
	wire<4> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4915_q
	// \src: top.v:4443.13-4443.20
	wire<2> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4915__q;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4914_q
	// \src: top.v:4442.13-4442.20
	wire<4> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4914__q;
	// \hdlname: unity_link_inst core_inst sent_ready
	// \src: top.v:12375.8-12375.18
	wire<1> p_unity__link__inst_2e_core__inst_2e_sent__ready;
	// \hdlname: unity_link_inst core_inst group_is_set
	// \src: top.v:12345.8-12345.20
	wire<1> p_unity__link__inst_2e_core__inst_2e_group__is__set;
	// \hdlname: unity_link_inst core_inst access_failure
	// \src: top.v:12343.14-12343.28
	wire<4> p_unity__link__inst_2e_core__inst_2e_access__failure;
	// \hdlname: unity_link_inst core_inst memory_word
	// \src: top.v:12323.15-12323.26
	wire<32> p_unity__link__inst_2e_core__inst_2e_memory__word;
	// \hdlname: unity_link_inst core_inst character_valid
	// \src: top.v:12294.8-12294.23
	wire<1> p_unity__link__inst_2e_core__inst_2e_character__valid;
	// \hdlname: unity_link_inst core_inst character_in
	// \src: top.v:12293.14-12293.26
	wire<9> p_unity__link__inst_2e_core__inst_2e_character__in;
	// \hdlname: unity_link_inst core_inst fifo_out_valid
	// \src: top.v:12291.8-12291.22
	wire<1> p_unity__link__inst_2e_core__inst_2e_fifo__out__valid;
	// \hdlname: unity_link_inst core_inst flush
	// \src: top.v:12283.11-12283.16
	wire<1> p_unity__link__inst_2e_core__inst_2e_flush;
	// \src: top.v:13247.18-13247.26
	/*output*/ wire<32> p_wb__dat__o;
	// \src: top.v:13246.17-13246.23
	/*output*/ wire<8> p_wb__adr;
	// \src: top.v:13245.17-13245.23
	/*output*/ value<4> p_wb__sel;
	// \src: top.v:13244.11-13244.16
	/*output*/ wire<1> p_wb__we;
	// \src: top.v:13243.11-13243.17
	/*output*/ wire<1> p_wb__stb;
	// \src: top.v:13242.11-13242.17
	/*output*/ value<1> p_wb__cyc;
	// \src: top.v:13241.11-13241.20
	/*output*/ wire<1> p_out__flush;
	// \src: top.v:13240.11-13240.20
	/*output*/ wire<1> p_out__valid;
	// \src: top.v:13239.17-13239.25
	/*output*/ value<8> p_out__data;
	// \src: top.v:13238.11-13238.19
	/*output*/ wire<1> p_in__ready;
	// \src: top.v:13237.11-13237.19
	/*input*/ value<1> p_wb__stall;
	// \src: top.v:13236.11-13236.17
	/*input*/ value<1> p_wb__err;
	// \src: top.v:13235.11-13235.17
	/*input*/ value<1> p_wb__ack;
	// \src: top.v:13234.18-13234.26
	/*input*/ value<32> p_wb__dat__i;
	// \src: top.v:13233.18-13233.25
	/*input*/ value<16> p_trigger;
	// \src: top.v:13232.11-13232.20
	/*input*/ value<1> p_out__ready;
	// \src: top.v:13231.11-13231.19
	/*input*/ value<1> p_in__valid;
	// \src: top.v:13230.11-13230.18
	/*input*/ value<1> p_in__lost;
	// \src: top.v:13229.17-13229.24
	/*input*/ value<8> p_in__data;
	// \src: top.v:13228.11-13228.14
	/*input*/ value<1> p_rst;
	// \src: top.v:13227.11-13227.14
	/*input*/ value<1> p_clk;
	value<1> prev_p_clk;
	bool posedge_p_clk() const {
		return !prev_p_clk.slice<0>().val() && p_clk.slice<0>().val();
	}
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6178
	// \src: top.v:3396.13-3396.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178 { 64u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst losses
	// \src: top.v:640.13-640.19
	memory<8> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses { 16u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst counters
	// \src: top.v:612.14-612.22
	memory<16> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters { 16u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst divisors
	// \src: top.v:584.14-584.22
	memory<16> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors { 16u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6180
	// \src: top.v:3466.13-3466.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6180 { 64u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6182
	// \src: top.v:3536.13-3536.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6182 { 64u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6184
	// \src: top.v:3606.13-3606.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6184 { 64u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst last
	// \src: top.v:5980.14-5980.18
	memory<32> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last { 8192u };
	// \hdlname: unity_link_inst core_inst response_ring_inst memory
	// \src: top.v:6625.14-6625.20
	memory<32> memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory { 256u };
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst memory
	// \src: top.v:3773.14-3773.20
	memory<32> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_memory { 1024u };
	// \hdlname: unity_link_inst core_inst tx_fifo_inst memory
	// \no_rw_check: 1
	// \src: top.v:1139.36-1139.42
	memory<10> memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory { 256u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst list
	// \src: top.v:5970.13-5970.17
	memory<8> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_list { 4096u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst settings_memory
	// \src: top.v:5914.14-5914.29
	memory<14> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory { 16u };
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst state_memory
	// \src: top.v:5942.13-5942.25
	memory<10> memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory { 16u };
	// \hdlname: unity_link_inst core_inst rx_fifo_inst memory
	// \no_rw_check: 1
	// \src: top.v:12168.36-12168.42
	memory<9> memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory { 256u };
	// \hdlname: unity_link_inst core_inst request_memory_inst memory
	// \src: top.v:9082.14-9082.20
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
		if (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__word.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5055__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5057__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3439__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3437__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6659__q.commit(observer)) changed = true;
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
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6177__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__losses.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6595__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6594__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6587__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6586__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6637__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n333__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n334__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n341__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n342__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6970__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6971__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6972__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6973__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6986__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6990__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6996__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__ring__room.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4948__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4944__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4938__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4932__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4930__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4927__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4926__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4924__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4915__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4914__q.commit(observer)) changed = true;
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
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_list.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory.commit(observer)) changed = true;
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
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u}, value<4>{0xfu},
		value<4>{0xau}, value<4>{0xfu}, value<4>{0x2u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0xau}, value<4>{0xcu},
		value<4>{0xau}, value<4>{0x9u}, value<4>{0xbu}, value<4>{0x3u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0xfu}, value<4>{0xfu},
		value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0xfu}, value<4>{0x7u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x3u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_1), std::end(mem_init_1), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178.data[0]);
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
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u}, value<4>{0xfu},
		value<4>{0xau}, value<4>{0xfu}, value<4>{0x2u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0xau}, value<4>{0xcu},
		value<4>{0xau}, value<4>{0x9u}, value<4>{0xbu}, value<4>{0x3u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0xfu}, value<4>{0xfu},
		value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0xfu}, value<4>{0x7u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x3u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_5), std::end(mem_init_5), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6180.data[0]);
	static const value<4> mem_init_6[64] {
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u}, value<4>{0xfu},
		value<4>{0xau}, value<4>{0xfu}, value<4>{0x2u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0xau}, value<4>{0xcu},
		value<4>{0xau}, value<4>{0x9u}, value<4>{0xbu}, value<4>{0x3u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0xfu}, value<4>{0xfu},
		value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0xfu}, value<4>{0x7u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x3u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_6), std::end(mem_init_6), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6182.data[0]);
	static const value<4> mem_init_7[64] {
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u}, value<4>{0xfu},
		value<4>{0xau}, value<4>{0xfu}, value<4>{0x2u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0xau}, value<4>{0xcu},
		value<4>{0xau}, value<4>{0x9u}, value<4>{0xbu}, value<4>{0x3u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0xfu}, value<4>{0xfu},
		value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0xfu}, value<4>{0xfu}, value<4>{0x7u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x3u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_7), std::end(mem_init_7), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6184.data[0]);
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
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5474_o
	// \src: top.v:1936.8-1936.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5474__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4340__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5465_o
	// \src: top.v:1934.8-1934.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5465__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4339__CMP;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2562_o
	// \src: top.v:6863.8-6863.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2562__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4338__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5447_o
	// \src: top.v:1930.8-1930.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5447__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2542_o
	// \src: top.v:6859.8-6859.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2542__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1524_o
	// \src: top.v:9392.8-9392.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1524__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1526_o
	// \src: top.v:9393.8-9393.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1526__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1527_o
	// \src: top.v:9394.8-9394.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1530_o
	// \src: top.v:9395.8-9395.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1530__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1556_o
	// \src: top.v:9403.8-9403.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5435_o
	// \src: top.v:1926.8-1926.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5435__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1584_o
	// \src: top.v:9412.8-9412.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1601_o
	// \src: top.v:9414.13-9414.20
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1612_o
	// \src: top.v:9418.8-9418.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1612__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1618_o
	// \src: top.v:9421.8-9421.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1618__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1621_o
	// \src: top.v:9422.8-9422.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1621__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1624_o
	// \src: top.v:9423.8-9423.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1624__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3028_o
	// \src: top.v:7140.15-7140.22
	value<18> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3028__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4337__CMP;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3279_o
	// \src: top.v:7340.8-7340.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1643_o
	// \src: top.v:9433.14-9433.21
	value<9> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1643__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6056_o
	// \src: top.v:2179.13-2179.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6056__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5381_o
	// \src: top.v:1911.8-1911.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5381__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5372_o
	// \src: top.v:1909.8-1909.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5372__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5363_o
	// \src: top.v:1907.8-1907.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5363__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5354_o
	// \src: top.v:1905.8-1905.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5354__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1679_o
	// \src: top.v:9467.16-9467.23
	value<121> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1679__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1682_o
	// \src: top.v:9470.8-9470.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1682__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1691_o
	// \src: top.v:9476.8-9476.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1698_o
	// \src: top.v:9482.8-9482.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1698__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5345_o
	// \src: top.v:1903.8-1903.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5345__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1701_o
	// \src: top.v:9484.8-9484.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1701__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1702_o
	// \src: top.v:9485.8-9485.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1703_o
	// \src: top.v:9486.8-9486.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1703__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5344_o
	// \src: top.v:1902.8-1902.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5344__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5338_o
	// \src: top.v:1898.8-1898.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5338__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5335_o
	// \src: top.v:1896.8-1896.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5335__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5140_o
	// \src: top.v:1806.8-1806.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5140__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5324_o
	// \src: top.v:1893.8-1893.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5324__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1760_o
	// \src: top.v:9508.8-9508.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1760__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1763_o
	// \src: top.v:9510.8-9510.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1763__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2398_o
	// \src: top.v:6786.8-6786.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2398__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5323_o
	// \src: top.v:1892.8-1892.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5323__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5320_o
	// \src: top.v:1890.8-1890.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5320__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1794_o
	// \src: top.v:9527.8-9527.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1794__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1797_o
	// \src: top.v:9529.8-9529.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1797__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1803_o
	// \src: top.v:9533.8-9533.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1803__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1804_o
	// \src: top.v:9534.8-9534.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1804__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1807_o
	// \src: top.v:9536.8-9536.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1807__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5295_o
	// \src: top.v:1882.8-1882.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5295__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5291_o
	// \src: top.v:1881.8-1881.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5291__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2372_o
	// \src: top.v:6771.8-6771.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2372__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5276_o
	// \src: top.v:1876.14-1876.21
	value<2> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5276__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2348_o
	// \src: top.v:6763.8-6763.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2345_o
	// \src: top.v:6761.8-6761.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1851_o
	// \src: top.v:9560.8-9560.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1851__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1853_o
	// \src: top.v:9561.8-9561.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1853__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1857_o
	// \src: top.v:9564.8-9564.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3472__CMP;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2326_o
	// \src: top.v:6752.8-6752.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2326__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2319_o
	// \src: top.v:6751.8-6751.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3473__CMP;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2315_o
	// \src: top.v:6749.8-6749.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2315__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1895_o
	// \src: top.v:9578.8-9578.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1901_o
	// \src: top.v:9582.8-9582.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1901__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1907_o
	// \src: top.v:9586.8-9586.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3476__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3478__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3479__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1948_o
	// \src: top.v:9608.8-9608.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1948__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1954_o
	// \src: top.v:9609.8-9609.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1954__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1962_o
	// \src: top.v:9611.8-9611.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1962__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3259_o
	// \src: top.v:7326.8-7326.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3259__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2282_o
	// \src: top.v:6730.8-6730.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4570_o
	// \src: top.v:4282.8-4282.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4570__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4572_o
	// \src: top.v:4283.8-4283.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4572__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1973_o
	// \src: top.v:9620.8-9620.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1973__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4574_o
	// \src: top.v:4284.8-4284.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2254_o
	// \src: top.v:6720.8-6720.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2254__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6017_o
	// \src: top.v:2162.8-2162.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6017__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2006_o
	// \src: top.v:9638.8-9638.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2006__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5269_o
	// \src: top.v:1869.15-1869.22
	value<26> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5269__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2229_o
	// \src: top.v:6710.8-6710.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2229__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2217_o
	// \src: top.v:6706.8-6706.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2217__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2214_o
	// \src: top.v:6704.8-6704.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2214__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5137_o
	// \src: top.v:1804.8-1804.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5137__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4592_o
	// \src: top.v:4294.14-4294.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4592__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2065_o
	// \src: top.v:9670.14-9670.21
	value<10> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2065__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst failed
	// \src: top.v:6694.8-6694.14
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed;
	// \hdlname: unity_link_inst core_inst request_executor_inst last_word
	// \src: top.v:6692.8-6692.17
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word;
	// \hdlname: unity_link_inst core_inst request_executor_inst is_masked
	// \src: top.v:6690.8-6690.17
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked;
	// \hdlname: unity_link_inst core_inst request_executor_inst is_queue
	// \src: top.v:6689.8-6689.16
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4394_o
	// \src: top.v:4194.8-4194.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4394__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2085_o
	// \src: top.v:9690.16-9690.23
	value<146> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2085__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2087_o
	// \src: top.v:9692.8-9692.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2087__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4372_o
	// \src: top.v:4188.8-4188.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4372__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5266_o
	// \src: top.v:1866.14-1866.21
	value<9> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5266__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3942__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3941__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4364_o
	// \src: top.v:4186.8-4186.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4364__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5109_o
	// \src: top.v:1786.8-1786.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5109__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4352_o
	// \src: top.v:4182.8-4182.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4352__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3249_o
	// \src: top.v:7321.8-7321.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4342_o
	// \src: top.v:4180.8-4180.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4342__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3245_o
	// \src: top.v:7319.14-7319.21
	value<2> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3245__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5087_o
	// \src: top.v:1772.8-1772.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5087__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5079_o
	// \src: top.v:1770.8-1770.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5079__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst load_word
	// \src: top.v:1763.8-1763.17
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4326_o
	// \src: top.v:4174.8-4174.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4326__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4319_o
	// \src: top.v:4173.8-4173.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst advance
	// \src: top.v:1760.8-1760.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst n5022_o
	// \src: top.v:3695.15-3695.22
	value<11> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5022__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6370_o
	// \src: top.v:1259.14-1259.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6370__o_5b_2_3a_0_5d_;
	// \src: top.v:5971.3-5973.35
	value<8> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4951__data_5b_7_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_sample_ring_inst n5026_o
	// \src: top.v:3698.15-3698.22
	value<11> p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5026__o;
	// \src: top.v:6626.3-6628.37
	value<32> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3444__data_5b_31_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4108_o
	// \src: top.v:4104.8-4104.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4108__o;
	// \src: top.v:5961.3-5963.42
	value<10> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4948__data_5b_9_3a_0_5d_;
	// \src: top.v:5936.3-5938.42
	value<4> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5938_24_1567__ADDR_5b_3_3a_0_5d__24_2023;
	// \src: top.v:5933.3-5935.45
	value<14> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4944__data_5b_13_3a_0_5d_;
	// \src: top.v:662.3-664.40
	value<8> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6996__data_5b_7_3a_0_5d_;
	// \src: top.v:659.3-661.37
	value<8> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6994__data_5b_7_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4279__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4278__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4277__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4276__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4275__CMP;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4651;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4655;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4667;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4633_o
	// \src: top.v:4313.8-4313.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4633__o;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4677;
	// \src: top.v:631.3-633.42
	value<16> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6990__data_5b_15_3a_0_5d_;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4685;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4640_o
	// \src: top.v:4317.8-4317.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4640__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4096__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4094__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4093__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4091__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4090__CMP;
	// \hdlname: unity_link_inst core_inst response_ring_inst n3404_o
	// \src: top.v:6547.14-6547.21
	value<9> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3404__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3887__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3835_o
	// \src: top.v:3976.8-3976.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3842_o
	// \src: top.v:3977.8-3977.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3842__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3843_o
	// \src: top.v:3978.8-3978.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3843__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5952_o
	// \src: top.v:2129.13-2129.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5952__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3858_o
	// \src: top.v:3985.8-3985.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3858__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3860_o
	// \src: top.v:3986.8-3986.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3867_o
	// \src: top.v:3987.8-3987.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3867__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3886__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3885__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4281_o
	// \src: top.v:4159.8-4159.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4281__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3884__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6462_o
	// \src: top.v:1312.8-1312.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6462__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6453_o
	// \src: top.v:1310.8-1310.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6453__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6448_o
	// \src: top.v:1309.8-1309.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6448__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4073__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4074__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4268_o
	// \src: top.v:4154.8-4154.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4268__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6310_o
	// \src: top.v:1224.14-1224.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6310__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6303_o
	// \src: top.v:1219.14-1219.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6303__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3602__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6296_o
	// \src: top.v:1214.14-1214.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6296__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4259_o
	// \src: top.v:4151.8-4151.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4259__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst tick_inst n6645_o
	// \src: top.v:838.8-838.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6645__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3702_o
	// \src: top.v:3889.15-3889.22
	value<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5257_o
	// \src: top.v:1857.15-1857.22
	value<41> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5257__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6289_o
	// \src: top.v:1209.14-1209.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6289__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6348_o
	// \src: top.v:1244.14-1244.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6348__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6334_o
	// \src: top.v:1242.8-1242.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6334__o;
	// \src: top.v:3774.3-3776.37
	value<32> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_5c_n5062__data_5b_31_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6329_o
	// \src: top.v:1238.15-1238.22
	value<13> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6329__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6363_o
	// \src: top.v:1254.14-1254.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6363__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3816__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3815__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4248_o
	// \src: top.v:4148.14-4148.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4248__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6282_o
	// \src: top.v:1204.14-1204.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6282__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6275_o
	// \src: top.v:1199.14-1199.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6275__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3628__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3635__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6268_o
	// \src: top.v:1194.14-1194.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6268__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3637__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3641__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3642__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3660__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6247_o
	// \src: top.v:1187.13-1187.20
	value<7> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6247__o_5b_6_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3674__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6260_o
	// \src: top.v:1189.14-1189.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6260__o;
	// \src: top.v:1143.3-1145.35
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_1145_24_327__EN_5b_9_3a_0_5d__24_378_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6243_o
	// \src: top.v:1185.8-1185.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6243__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4225_o
	// \src: top.v:4141.8-4141.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4225__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3677__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4218_o
	// \src: top.v:4136.8-4136.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4218__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6197_o
	// \src: top.v:1170.8-1170.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6197__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4210_o
	// \src: top.v:4134.8-4134.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4210__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4207_o
	// \src: top.v:4133.8-4133.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4207__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst advance
	// \src: top.v:1165.8-1165.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_advance;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3338__CMP;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4689;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3355__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3362__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3368__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3373__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3377__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst carry_out
	// \src: top.v:3826.8-3826.17
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3380__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4538_o
	// \src: top.v:4264.8-4264.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4538__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4431_o
	// \src: top.v:4211.8-4211.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4431__o;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4693;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4695;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3392__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3393__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3394__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3395__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst clear_timer
	// \src: top.v:3831.15-3831.26
	value<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer;
	// \src: top.v:603.3-605.42
	value<16> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6986__data_5b_15_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3404__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3405__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3406__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3407__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4646_o
	// \src: top.v:4320.8-4320.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4646__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3416__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3417__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3418__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3419__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4652_o
	// \src: top.v:4323.8-4323.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4652__o;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4727;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3428__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3873_o
	// \src: top.v:3990.8-3990.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3873__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3429__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3436__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3437__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3438__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3439__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3440__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3441__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3442__CMP;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3878_o
	// \src: top.v:3993.8-3993.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3878__o;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4739;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4658_o
	// \src: top.v:4326.8-4326.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4658__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst advance
	// \src: top.v:11030.8-11030.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_advance;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst accepted
	// \src: top.v:3860.8-3860.16
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n395_o
	// \src: top.v:11048.8-11048.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n395__o;
	// \src: top.v:5981.3-5983.35
	value<32> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4954__data_5b_31_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3179_o
	// \src: top.v:7269.14-7269.21
	value<8> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3179__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n444_o
	// \src: top.v:11063.14-11063.20
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6356_o
	// \src: top.v:1249.14-1249.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6356__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5859_o
	// \src: top.v:2087.13-2087.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5859__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3174_o
	// \src: top.v:7265.8-7265.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5547_o
	// \src: top.v:1960.14-1960.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5547__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n503_o
	// \src: top.v:11105.14-11105.20
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n503__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n504_o
	// \src: top.v:11106.8-11106.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n504__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3170_o
	// \src: top.v:7264.8-7264.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3562_o
	// \src: top.v:6160.8-6160.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3562__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3560_o
	// \src: top.v:6159.8-6159.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3560__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n535_o
	// \src: top.v:11135.8-11135.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n535__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n544_o
	// \src: top.v:11137.8-11137.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n544__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n545_o
	// \src: top.v:11138.8-11138.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n545__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3541_o
	// \src: top.v:6149.8-6149.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3541__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n559_o
	// \src: top.v:11147.8-11147.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n559__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6377_o
	// \src: top.v:1264.14-1264.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6377__o_5b_2_3a_0_5d_;
	// \src: top.v:9083.3-9085.40
	value<32> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2166__data_5b_31_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n612_o
	// \src: top.v:11158.8-11158.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n612__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n632_o
	// \src: top.v:11167.8-11167.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n632__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3523_o
	// \src: top.v:6138.8-6138.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n678_o
	// \src: top.v:11186.8-11186.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n678__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n698_o
	// \src: top.v:11195.8-11195.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n698__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3497_o
	// \src: top.v:6124.8-6124.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3497__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3496_o
	// \src: top.v:6123.8-6123.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3496__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3489_o
	// \src: top.v:6122.8-6122.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3489__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5179_o
	// \src: top.v:1826.8-1826.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5179__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3883_o
	// \src: top.v:3996.8-3996.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3883__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3468_o
	// \src: top.v:6111.8-6111.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3468__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3461_o
	// \src: top.v:6110.8-6110.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3461__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3458_o
	// \src: top.v:6109.8-6109.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3458__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5166_o
	// \src: top.v:1821.8-1821.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5166__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst grant_sample
	// \src: top.v:6106.8-6106.20
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n764_o
	// \src: top.v:11234.15-11234.21
	value<30> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n764__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3159_o
	// \src: top.v:7257.14-7257.21
	value<5> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3159__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n767_o
	// \src: top.v:11237.14-11237.20
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n767__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n775_o
	// \src: top.v:11242.8-11242.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n775__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3157_o
	// \src: top.v:7255.14-7255.21
	value<5> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3157__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3156_o
	// \src: top.v:7254.15-7254.22
	value<35> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3156__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3154_o
	// \src: top.v:7252.15-7252.22
	value<18> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3154__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4559_o
	// \src: top.v:4277.8-4277.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4559__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6185_data
	// \src: top.v:2254.14-2254.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6185__data;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6183_data
	// \src: top.v:2253.14-2253.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6183__data;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6181_data
	// \src: top.v:2252.14-2252.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6181__data;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n6179_data
	// \src: top.v:2251.14-2251.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6179__data;
	// \hdlname: unity_link_inst core_inst bus_master_inst sample
	// \src: top.v:6082.11-6082.17
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5796_o
	// \src: top.v:2061.14-2061.21
	value<6> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5796__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst letter
	// \src: top.v:9125.8-9125.14
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter;
	// \hdlname: unity_link_inst core_inst request_decoder_inst digit
	// \src: top.v:9126.8-9126.13
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit;
	// \hdlname: unity_link_inst core_inst request_decoder_inst field
	// \src: top.v:9127.14-9127.19
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field;
	// \hdlname: unity_link_inst core_inst request_decoder_inst left
	// \src: top.v:9128.14-9128.18
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst is_due
	// \src: top.v:29.8-29.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst counts
	// \src: top.v:31.8-31.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counts;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n869_o
	// \src: top.v:11299.15-11299.21
	value<26> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n869__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n872_o
	// \src: top.v:11302.14-11302.20
	value<9> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n872__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n875_o
	// \src: top.v:11304.8-11304.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n875__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5756_o
	// \src: top.v:2040.13-2040.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5756__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5753_o
	// \src: top.v:2037.8-2037.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5753__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n999_o
	// \src: top.v:9151.8-9151.14
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n999__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3127_o
	// \src: top.v:7225.15-7225.22
	value<18> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3127__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst timer_inst n6717_o
	// \src: top.v:56.8-56.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6717__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3888_o
	// \src: top.v:3999.8-3999.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3888__o;
	// \src: top.v:1142.21-1142.27
	value<10> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_1142_24_374__DATA;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3893_o
	// \src: top.v:4002.8-4002.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3893__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3898_o
	// \src: top.v:4005.8-4005.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3898__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1019_o
	// \src: top.v:9160.8-9160.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1019__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3903_o
	// \src: top.v:4008.8-4008.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3903__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3908_o
	// \src: top.v:4011.8-4011.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3908__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3913_o
	// \src: top.v:4014.8-4014.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3913__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3918_o
	// \src: top.v:4017.8-4017.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3918__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3923_o
	// \src: top.v:4020.8-4020.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3923__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3928_o
	// \src: top.v:4023.8-4023.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3933_o
	// \src: top.v:4026.8-4026.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3933__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3938_o
	// \src: top.v:4029.8-4029.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3938__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3943_o
	// \src: top.v:4033.8-4033.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3943__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3946_o
	// \src: top.v:4036.15-4036.22
	value<16> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3946__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n3950_o
	// \src: top.v:4039.8-4039.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6547_o
	// \src: top.v:992.8-992.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6547__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6539_o
	// \src: top.v:987.8-987.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6539__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6532_o
	// \src: top.v:982.8-982.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6532__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6529_o
	// \src: top.v:979.8-979.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6529__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1031_o
	// \src: top.v:9165.8-9165.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n6498_o
	// \src: top.v:971.8-971.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6498__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5162_o
	// \src: top.v:1818.8-1818.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5162__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5725_o
	// \src: top.v:2030.8-2030.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5725__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1054_o
	// \src: top.v:9173.8-9173.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1059_o
	// \src: top.v:9176.14-9176.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1064_o
	// \src: top.v:9177.14-9177.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1067_o
	// \src: top.v:9179.8-9179.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1067__o;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst n6607_o
	// \src: top.v:883.8-883.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6607__o;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst n6605_o
	// \src: top.v:881.8-881.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6605__o;
	// \hdlname: unity_link_inst core_inst with_send_immediate_send_immediate_inst n6602_o
	// \src: top.v:879.8-879.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6602__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n245_o
	// \src: top.v:12000.8-12000.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n246_o
	// \src: top.v:12001.8-12001.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n276_o
	// \src: top.v:12008.8-12008.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n276__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n279_o
	// \src: top.v:12011.8-12011.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n279__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n286_o
	// \src: top.v:12016.8-12016.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n286__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n294_o
	// \src: top.v:12021.8-12021.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1119_o
	// \src: top.v:9197.8-9197.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1119__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1125_o
	// \src: top.v:9200.8-9200.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1125__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1128_o
	// \src: top.v:9201.8-9201.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1128__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1131_o
	// \src: top.v:9202.8-9202.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1131__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2719_o
	// \src: top.v:6964.15-6964.22
	value<12> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2719__o;
	// \hdlname: unity_link_inst bus_done
	// \src: top.v:13075.8-13075.16
	value<1> p_unity__link__inst_2e_bus__done;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2715_o
	// \src: top.v:6961.14-6961.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2715__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2714_o
	// \src: top.v:6960.14-6960.21
	value<3> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2714__o;
	// \src: top.v:12171.20-12171.26
	value<9> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_12171_24_3257__DATA;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6398_o
	// \src: top.v:1279.14-1279.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6398__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1154_o
	// \src: top.v:9215.8-9215.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1154__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1157_o
	// \src: top.v:9218.8-9218.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1157__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2712_o
	// \src: top.v:6958.8-6958.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2712__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1166_o
	// \src: top.v:9227.8-9227.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1166__o;
	// \hdlname: unity_link_inst core_inst n198_o
	// \src: top.v:12502.8-12502.14
	value<1> p_unity__link__inst_2e_core__inst_2e_n198__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2699_o
	// \src: top.v:6945.13-6945.20
	value<2> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2699__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2693_o
	// \src: top.v:6939.13-6939.20
	value<3> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2693__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3081_o
	// \src: top.v:7182.14-7182.21
	value<15> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3081__o;
	// \hdlname: unity_link_inst core_inst with_groups_ring_write
	// \src: top.v:12464.8-12464.30
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3071_o
	// \src: top.v:7174.8-7174.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3071__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3062_o
	// \src: top.v:7171.8-7171.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3062__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5156_o
	// \src: top.v:1813.8-1813.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5156__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1249_o
	// \src: top.v:9269.8-9269.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1252_o
	// \src: top.v:9270.8-9270.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1255_o
	// \src: top.v:9271.8-9271.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1258_o
	// \src: top.v:9272.8-9272.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1261_o
	// \src: top.v:9273.8-9273.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1265_o
	// \src: top.v:9274.8-9274.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1268_o
	// \src: top.v:9275.8-9275.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4227__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1290_o
	// \src: top.v:9279.8-9279.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1290__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1293_o
	// \src: top.v:9280.8-9280.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5563_o
	// \src: top.v:1975.8-1975.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5563__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1309_o
	// \src: top.v:9285.8-9285.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1309__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1315_o
	// \src: top.v:9287.8-9287.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6384_o
	// \src: top.v:1269.14-1269.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6384__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1339_o
	// \src: top.v:9293.8-9293.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1339__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1345_o
	// \src: top.v:9295.8-9295.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1345__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1348_o
	// \src: top.v:9296.8-9296.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1348__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1351_o
	// \src: top.v:9297.8-9297.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1351__o;
	// \hdlname: unity_link_inst core_inst tx_entry
	// \src: top.v:12376.14-12376.22
	value<10> p_unity__link__inst_2e_core__inst_2e_tx__entry;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1367_o
	// \src: top.v:9301.8-9301.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1367__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5557_o
	// \src: top.v:1970.8-1970.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5557__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5556_o
	// \src: top.v:1969.14-1969.21
	value<6> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5556__o;
	// \hdlname: unity_link_inst core_inst answer_has_id
	// \src: top.v:12360.8-12360.21
	value<1> p_unity__link__inst_2e_core__inst_2e_answer__has__id;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5555_o
	// \src: top.v:1968.14-1968.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5555__o;
	// \hdlname: unity_link_inst core_inst answer_taken
	// \src: top.v:12355.8-12355.20
	value<1> p_unity__link__inst_2e_core__inst_2e_answer__taken;
	// \hdlname: unity_link_inst core_inst answer_valid
	// \src: top.v:12354.8-12354.20
	value<1> p_unity__link__inst_2e_core__inst_2e_answer__valid;
	// \hdlname: unity_link_inst core_inst group_done
	// \src: top.v:12348.8-12348.18
	value<1> p_unity__link__inst_2e_core__inst_2e_group__done;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1404_o
	// \src: top.v:9318.14-9318.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5548_o
	// \src: top.v:1961.8-1961.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5548__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1409_o
	// \src: top.v:9321.8-9321.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o;
	// \hdlname: unity_link_inst core_inst access_done
	// \src: top.v:12337.8-12337.19
	value<1> p_unity__link__inst_2e_core__inst_2e_access__done;
	// \hdlname: unity_link_inst core_inst access_granted
	// \src: top.v:12336.8-12336.22
	value<1> p_unity__link__inst_2e_core__inst_2e_access__granted;
	// \hdlname: unity_link_inst core_inst access_more
	// \src: top.v:12332.8-12332.19
	value<1> p_unity__link__inst_2e_core__inst_2e_access__more;
	// \hdlname: unity_link_inst core_inst access_write
	// \src: top.v:12331.8-12331.20
	value<1> p_unity__link__inst_2e_core__inst_2e_access__write;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5546_o
	// \src: top.v:1959.14-1959.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5546__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4723_o
	// \src: top.v:4359.8-4359.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4723__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1413_o
	// \src: top.v:9324.8-9324.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4718_o
	// \src: top.v:4356.8-4356.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4718__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4712_o
	// \src: top.v:4353.8-4353.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4712__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4706_o
	// \src: top.v:4350.8-4350.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4706__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4700_o
	// \src: top.v:4347.8-4347.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4700__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1419_o
	// \src: top.v:9328.8-9328.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1419__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4694_o
	// \src: top.v:4344.8-4344.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4694__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1420_o
	// \src: top.v:9329.8-9329.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4688_o
	// \src: top.v:4341.8-4341.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4688__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4682_o
	// \src: top.v:4338.8-4338.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4682__o;
	// \hdlname: unity_link_inst core_inst hold
	// \src: top.v:12305.8-12305.12
	value<1> p_unity__link__inst_2e_core__inst_2e_hold;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5544_o
	// \src: top.v:1957.14-1957.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5544__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4676_o
	// \src: top.v:4335.8-4335.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4676__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1424_o
	// \src: top.v:9332.8-9332.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4670_o
	// \src: top.v:4332.8-4332.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4670__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5540_o
	// \src: top.v:1956.8-1956.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5540__o;
	// \hdlname: unity_link_inst core_inst fifo_out_ready
	// \src: top.v:12292.8-12292.22
	value<1> p_unity__link__inst_2e_core__inst_2e_fifo__out__ready;
	// \hdlname: unity_link_inst core_inst with_groups_subscription_manager_inst n4664_o
	// \src: top.v:4329.8-4329.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4664__o;
	// \src: top.v:9086.3-9088.41
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_9088_24_2706__EN_5b_31_3a_0_5d__24_2712_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1428_o
	// \src: top.v:9335.8-9335.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n466_o
	// \src: top.v:11078.14-11078.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n466__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4226__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1432_o
	// \src: top.v:9338.8-9338.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n452_o
	// \src: top.v:11068.14-11068.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n452__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3051_o
	// \src: top.v:7162.15-7162.22
	value<18> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3051__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n459_o
	// \src: top.v:11073.14-11073.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n459__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5519_o
	// \src: top.v:1949.8-1949.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5519__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n487_o
	// \src: top.v:11093.14-11093.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n487__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4225__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5514_o
	// \src: top.v:1947.8-1947.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5514__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n473_o
	// \src: top.v:11083.14-11083.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n473__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1443_o
	// \src: top.v:9347.8-9347.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n480_o
	// \src: top.v:11088.14-11088.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n480__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1445_o
	// \src: top.v:9348.8-9348.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1446_o
	// \src: top.v:9349.8-9349.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n494_o
	// \src: top.v:11098.14-11098.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n494__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4343__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5507_o
	// \src: top.v:1945.8-1945.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5507__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5505_o
	// \src: top.v:1944.14-1944.21
	value<5> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5505__o;
	// \src: top.v:12172.3-12174.35
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_12174_24_3210__EN_5b_8_3a_0_5d__24_3261_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2559_o
	// \src: top.v:6862.14-6862.21
	value<3> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2559__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2583_o
	// \src: top.v:6872.14-6872.21
	value<2> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2583__o_5b_1_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5492_o
	// \src: top.v:1940.8-1940.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5492__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2588_o
	// \src: top.v:6876.8-6876.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2588__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2654_o
	// \src: top.v:6913.14-6913.21
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2654__o_5b_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4342__CMP;
	// \src: top.v:6629.3-6631.37
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_6631_24_2226__EN_5b_31_3a_0_5d__24_2252_5b_0_5d_;
	// \src: top.v:634.3-636.44
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_counters_24_top_2e_v_3a_636_24_34__EN_5b_15_3a_0_5d__24_175_5b_0_5d_;
	// \src: top.v:665.3-667.40
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_losses_24_top_2e_v_3a_667_24_51__EN_5b_7_3a_0_5d__24_186_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n6391_o
	// \src: top.v:1274.14-1274.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6391__o_5b_2_3a_0_5d_;
	// \src: top.v:5984.3-5986.41
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_last_24_top_2e_v_3a_5986_24_1586__EN_5b_31_3a_0_5d__24_2052_5b_0_5d_;
	// \src: top.v:5974.3-5976.37
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_list_24_top_2e_v_3a_5976_24_1585__EN_5b_7_3a_0_5d__24_2043_5b_0_5d_;
	// \src: top.v:5964.3-5966.41
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_state__memory_24_top_2e_v_3a_5966_24_1584__EN_5b_9_3a_0_5d__24_2034_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n5483_o
	// \src: top.v:1938.8-1938.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5483__o;
	// \src: top.v:5936.3-5938.42
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5938_24_1567__EN_5b_13_3a_0_5d__24_2025_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1478_o
	// \src: top.v:9375.15-9375.22
	value<11> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1478__o;
	// \src: top.v:3777.3-3779.37
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_3779_24_1521__EN_5b_31_3a_0_5d__24_1547_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1482_o
	// \src: top.v:9377.8-9377.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1482__o;
	// \src: top.v:11422.19-11422.34
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$xor$top.v:11422$3078
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o = xor_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<25,18>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<7,0>().val());
	// \src: top.v:1379.20-1379.66
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1379$391
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6243__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<4,3>().val(), value<1>{0x1u});
	// \src: top.v:7898.20-7898.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7898$2427
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<4>{0xcu});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11432$3080 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4564
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n452__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o.slice<7>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4323 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4324_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1377$390
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6247__o_5b_6_3a_0_5d_ = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6243__o.concat(logic_not<1>(value<29>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<4,3>()).val())).val(), value<1>{0x1u}) ? value<7>{0x5au} : value<7>{0x30u});
	// \src: top.v:7908.20-7908.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7908$2430
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<4>{0xfu});
	// \src: top.v:9845.20-9845.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9845$2748
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1067__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<11,8>().val());
	// \src: top.v:1392.20-1392.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$xor$top.v:1392$393
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6260__o = xor_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<12,5>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6247__o_5b_6_3a_0_5d_);
	// \src: top.v:1500.20-1500.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$xor$top.v:1500$417
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6348__o = xor_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<12,5>().val(), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<91,84>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9839$2746 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9837$2745 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:9835$2744 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9831$2742
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3>().val() ? (or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<2>().val()), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o) ? value<4>{0x5u} : value<4>{0xau}) : value<4>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11442$3082 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4566
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n459__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o.slice<6>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n452__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n452__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9841$2747 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:9819$2738
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<5>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o) ? value<4>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o);
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1402$395 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4596
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6268__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6260__o.slice<7>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6260__o.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6260__o.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1510$419 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4612
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6356__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6348__o.slice<7>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6348__o.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6348__o.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:9847.20-9847.47
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9847$2749
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1067__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<11,8>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:11608$3122 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11606$3121 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11604$3120
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n632__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<15,12>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<15,12>().val(), value<3>{0x6u}));
	// \src: top.v:11590.19-11590.36
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11590$3115
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n612__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<15,12>().val(), value<2>{0x3u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11452$3084 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4568
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n466__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o.slice<5>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n459__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n459__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:7817.20-7817.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7817$2391
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1701__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<3>{0x7u});
	// \src: top.v:7815.20-7815.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7815$2390
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1698__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<3>{0x4u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4676$1601 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:4674$1600
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o = and_uu<16>(or_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__trigger.curr), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9772$2725 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9770$2724 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9768$2723 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ge$top.v:9762$2721 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$le$top.v:9766$2722 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9758$2720 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9756$2719 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9752$2718 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9748$2717
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter = and_uu<1>(and_uu<1>(and_uu<1>((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1067__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<52>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<53>().val())), (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x1au}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<3>{0x7u})) ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1412$397 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4598
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6275__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6260__o.slice<6>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6268__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6268__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1520$421 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4614
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6363__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6348__o.slice<6>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6356__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6356__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:10834.20-10834.41
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10834$3011
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1948__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<16>().val() ? value<1>{0u} : value<1>{0x1u});
	// \src: top.v:7819.20-7819.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7819$2392
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1698__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1701__o);
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11462$3086 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4570
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n473__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o.slice<4>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n466__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n466__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:10894.20-10894.37
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10894$3032
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2006__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1948__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o);
	// \src: top.v:10571.20-10571.43
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10571$2923
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<117,109>().val());
	// \src: top.v:7804.20-7804.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7804$2385
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1530__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val());
	// \src: top.v:7781.20-7781.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7781$2374
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1526__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<2>{0x2u});
	// \src: top.v:7779.20-7779.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7779$2373
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1524__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<1>{0x1u});
	// \src: top.v:7467.20-7467.38
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7467$2264
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2229__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<23,20>().val(), value<2>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:11668$3139 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11666$3138 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11664$3137
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n698__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<7,4>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<7,4>().val(), value<3>{0x6u}));
	// \src: top.v:11650.19-11650.36
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11650$3132
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n678__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<7,4>().val(), value<2>{0x3u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1422$399 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4600
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6282__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6260__o.slice<5>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6275__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6275__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1530$423 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4616
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6370__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6348__o.slice<5>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6363__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6363__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:7806.20-7806.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7806$2386
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1803__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<2>{0x3u});
	// \src: top.v:10836.20-10836.41
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10836$3012
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1954__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<16>().val() ? value<1>{0u} : value<1>{0u});
	// \src: top.v:10249.20-10249.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10249$2847
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<4>{0x9u});
	// \src: top.v:10213.20-10213.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10213$2839
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1419__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<4>{0x8u});
	// \src: top.v:7783.20-7783.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7783$2375
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1524__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1526__o);
	// \src: top.v:7455.20-7455.38
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7455$2260
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2214__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<23,20>().val(), value<3>{0x5u});
	// \src: top.v:7573.20-7573.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7573$2304
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val(), value<3>{0x6u});
	// \src: top.v:7569.20-7569.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7569$2303
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val(), value<3>{0x4u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7515$2283 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:7513$2282
	p_unity__link__inst_2e_core__inst_2e_hold = (reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val()) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11472$3088 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4572
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n480__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o.slice<3>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n473__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n473__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10858$3019 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10854$3018 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10848$3016
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1973__o = or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1067__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<118>().val()), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<117>().val());
	// \src: top.v:10454.20-10454.37
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10454$2895
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1419__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o);
	// \src: top.v:10247.20-10247.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10247$2846
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x4u});
	// \src: top.v:10233.20-10233.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10233$2843
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x7u});
	// \src: top.v:10227.20-10227.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10227$2842
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x6u});
	// \src: top.v:10221.20-10221.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10221$2841
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x5u});
	// \src: top.v:10205.20-10205.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10205$2837
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<2>{0x2u});
	// \src: top.v:10199.20-10199.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10199$2836
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<1>{0x1u});
	// \src: top.v:7834.20-7834.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7834$2399
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<4>{0x8u});
	// \src: top.v:2373.20-2373.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2373$745
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5156__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<2,0>().val(), value<2>{0x3u});
	// \src: top.v:2359.20-2359.40
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2359$740
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5140__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<81,76>().val());
	// \src: top.v:7849.20-7849.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7849$2406
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1853__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<4>{0xau});
	// \src: top.v:7842.20-7842.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7842$2403
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1851__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<4>{0x9u});
	// \src: top.v:7775.20-7775.54
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7775$2371
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2562__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<137>().val() ? value<1>{0u} : value<1>{0x1u});
	// \src: top.v:7459.20-7459.38
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7459$2261
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2217__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<23,20>().val(), value<3>{0x6u});
	// \src: top.v:9947.20-9947.28
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9947$2785
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1166__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<129>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1432$401 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4602
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6289__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6260__o.slice<4>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6282__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6282__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1540$425 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4618
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6377__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6348__o.slice<4>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6370__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6370__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:7823.20-7823.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7823$2394
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1794__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<3>{0x5u});
	// \src: top.v:10682.20-10682.64
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ge$top.v:10682$2961
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1807__o = ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<52,45>().val(), value<5>{0x10u});
	// \src: top.v:9891.20-9891.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9891$2766
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1131__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o, value<3>{0x7u});
	// \src: top.v:9889.20-9889.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9889$2765
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1128__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o, value<3>{0x4u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:9887$2764 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9885$2763 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9883$2762
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1125__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o, value<2>{0x2u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o, value<4>{0x9u}));
	// \src: top.v:9881.20-9881.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9881$2761
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1119__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1064__o, value<1>{0x1u});
	// \src: top.v:2355.20-2355.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2355$739
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5137__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<2,0>().val(), value<3>{0x5u});
	// \src: top.v:2383.20-2383.28
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2383$748
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5162__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<10>().val());
	// \src: top.v:7825.20-7825.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7825$2395
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1797__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<3>{0x6u});
	// \src: top.v:1349.20-1349.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1349$384
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6197__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<2,0>().val(), value<1>{0x1u});
	// \src: top.v:4850.20-4850.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4850$1656
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4914__q.curr);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9929$2778 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9927$2777 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:9919$2774 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9917$2773 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9915$2772 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:9913$2771 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9911$2770
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1157__o = not_u<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_hold, or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<55>().val(), and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter), (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u})))));
	// \src: top.v:9923.20-9923.28
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9923$2775
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1154__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<130>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11482$3090 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4574
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n487__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n444__o.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n480__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n480__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:10840.20-10840.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10840$3014
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1962__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<4>{0xau});
	// \src: top.v:10251.20-10251.37
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10251$2848
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10215$2840 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10211$2838
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<2>{0x3u}), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1419__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3322 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3323_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3324_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3325_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3326_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3327_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3328_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3329_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10410$2873 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10430$2883 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10426$2881 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10422$2879 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10428$2882 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10424$2880 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10442$2889
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<1>{0x1u}) ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o ? value<4>{0xau} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<2>{0x2u}) ? ((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1530__o ? value<1>{0u} : value<1>{0x1u})) ? value<4>{0x4u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o ? value<4>{0x3u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1530__o ? value<4>{0xau} : value<4>{0u}))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<3>{0x4u}) ? value<4>{0x4u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<4>{0x8u}) ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o ? value<4>{0x6u} : value<4>{0xau}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<5>{0x10u}) ? value<4>{0x7u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<6>{0x20u}) ? value<4>{0x8u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1584__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<7>{0x40u}) ? value<4>{0x9u} : value<4>{0xau})))))));
	// \src: top.v:5129.20-5129.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5129$1756
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4210__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4914__q.curr, value<3>{0x6u});
	// \src: top.v:2399.20-2399.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2399$754
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5179__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<2,0>().val(), value<3>{0x4u});
	// \src: top.v:2389.20-2389.43
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:2389$750
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5166__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<43,35>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7891$2425 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7889$2424 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7887$2423
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o = or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1851__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1853__o), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<4>{0xbu}));
	// \src: top.v:7827.20-7827.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7827$2396
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1794__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1797__o);
	// \src: top.v:7808.20-7808.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7808$2387
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1530__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1803__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7800$2383 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7796$2381 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7790$2378
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2588__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2562__o, logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.curr)), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2562__o);
	// \src: top.v:7773.20-7773.60
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7773$2370
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2559__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<137>().val() ? value<3>{0x6u} : value<3>{0u});
	// \src: top.v:7549.20-7549.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7549$2296
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val(), value<3>{0x7u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$or$top.v:1345$383 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$not$top.v:1343$382
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_advance = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<25>().val()), p_unity__link__inst_2e_core__inst_2e_sent__ready.curr);
	// \src: top.v:4852.20-4852.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4852$1657
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3842__o = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1442$403 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4604
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6296__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6260__o.slice<3>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6289__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6289__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1550$427 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4620
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6384__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6348__o.slice<3>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6377__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6377__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:10629.20-10629.42
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10629$2940
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1760__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,37>().val());
	// \full_case: 1
	// \src: top.v:10360.19-10360.19|top.v:10360.5-10369.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3338_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3338__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<7>{0x40u});
	// \src: top.v:10040.20-10040.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10040$2805
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<3>{0x7u});
	// \src: top.v:10038.20-10038.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10038$2804
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<4>{0x9u});
	// \src: top.v:10036.20-10036.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10036$2803
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<4>{0xbu});
	// \src: top.v:10034.20-10034.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10034$2802
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x11u});
	// \src: top.v:10032.20-10032.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10032$2801
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<4>{0x8u});
	// \src: top.v:10030.20-10030.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10030$2800
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x17u});
	// \src: top.v:10028.20-10028.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10028$2799
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x12u});
	// \src: top.v:10069.20-10069.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10069$2809
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<4>{0xdu});
	// \src: top.v:10092.20-10092.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10092$2815
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x13u});
	// \src: top.v:10125.20-10125.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10125$2824
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1351__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x10u});
	// \src: top.v:10123.20-10123.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10123$2823
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1348__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<5>{0x18u});
	// \src: top.v:10121.20-10121.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10121$2822
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1345__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<50,46>().val(), value<4>{0xeu});
	// \src: top.v:6242.20-6242.34
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:6242$2129
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3461__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.curr);
	// \src: top.v:5131.20-5131.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5131$1757
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4210__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:7917.38-7917.38|top.v:7913.5-7923.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3797_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3677__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<4>{0x8u});
	// \src: top.v:8419.20-8419.47
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8419$2578
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3028__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<137>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<17,3>().concat(value<3>{0x7u}).val() : value<3>{0x4u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<28,17>()).concat(value<3>{0x6u}).val());
	// \full_case: 1
	// \src: top.v:7916.38-7916.38|top.v:7913.5-7923.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3798_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3635__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:7920.38-7920.38|top.v:7913.5-7923.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3794_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3674__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:7915.38-7915.38|top.v:7913.5-7923.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3799_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3628__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:7919.38-7919.38|top.v:7913.5-7923.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3795_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3641__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<2>{0x2u});
	// \src: top.v:7869.20-7869.47
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7869$2415
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2654__o_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_group__is__set.curr ? value<1>{0u} : value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:7918.38-7918.38|top.v:7913.5-7923.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3796_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3642__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<3>{0x4u});
	// \src: top.v:7792.20-7792.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7792$2379
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2583__o_5b_1_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2588__o ? value<2>{0x1u} : value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:7913.19-7913.19|top.v:7913.5-7923.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3800_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3637__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<8>{0x80u});
	// \full_case: 1
	// \src: top.v:8460.38-8460.38|top.v:8459.5-8469.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3660_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3660__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<7>{0x40u});
	// \src: top.v:2525.20-2525.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2525$789
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5335__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<6,3>().val(), value<3>{0x5u});
	// \src: top.v:7551.20-7551.41
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7551$2297
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2326__o = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:2287.20-2287.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2287$718
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5079__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<2,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4854$1658 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4848$1655 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:4846$1654 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4844$1653 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7577$2306 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7575$2305
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3843__o = and_uu<1>(and_uu<1>((or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o) ? value<1>{0x1u} : value<1>{0u}), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4927__q.curr, not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4924__q.curr))), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3842__o);
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11748$3159 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:11742$3157 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:11746$3158
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n775__o = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<45>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<44>().val()));
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11492$3092 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4576
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n494__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n452__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n487__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n487__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:10633.20-10633.63
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:10633$2941
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1763__o = gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,37>().val(), value<8>{0xffu});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9907$2769 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3453 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3454_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3455_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3456_CMP0
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1067__o ? value<1>{0u}.concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1131__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1128__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1125__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1119__o).val(), value<1>{0x1u}) ? value<3>{0x2u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1131__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1128__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1125__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1119__o).val(), value<3>{0x4u}) ? value<3>{0x7u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1131__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1128__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1125__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1119__o).val(), value<4>{0x8u}) ? value<3>{0x3u} : value<3>{0x1u})))).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<15,12>().val());
	// \src: top.v:10483.20-10483.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10483$2902
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1624__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o, value<3>{0x7u});
	// \src: top.v:10481.20-10481.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10481$2901
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1621__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o, value<3>{0x4u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10479$2900 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10477$2899 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10475$2898
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1618__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o, value<2>{0x2u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o, value<4>{0x9u}));
	// \src: top.v:10473.20-10473.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10473$2897
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1612__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o, value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10062.38-10062.38|top.v:10056.5-10065.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3436_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3436__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10049.34-10049.34|top.v:10044.5-10053.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3446_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3437__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10048.34-10048.34|top.v:10044.5-10053.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3447_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3438__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10047.34-10047.34|top.v:10044.5-10053.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3448_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3439__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10046.34-10046.34|top.v:10044.5-10053.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3449_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3440__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:10045.34-10045.34|top.v:10044.5-10053.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3450_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3441__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:10044.19-10044.19|top.v:10044.5-10053.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3451_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3442__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1268__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1265__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1255__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1252__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1249__o).val(), value<7>{0x40u});
	// \full_case: 1
	// \src: top.v:10082.19-10082.19|top.v:10082.5-10086.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3429_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3429__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10083.33-10083.33|top.v:10082.5-10086.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3428_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3428__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10109.19-10109.19|top.v:10109.5-10115.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3419_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3419__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10110.35-10110.35|top.v:10109.5-10115.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3418_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3418__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10111.35-10111.35|top.v:10109.5-10115.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3417_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3417__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10112.35-10112.35|top.v:10109.5-10115.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3416_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3416__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1261__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1293__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10138.19-10138.19|top.v:10138.5-10144.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3407_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3407__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1351__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10139.35-10139.35|top.v:10138.5-10144.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3406_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3406__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1351__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10140.35-10140.35|top.v:10138.5-10144.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3405_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3405__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1351__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10141.35-10141.35|top.v:10138.5-10144.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3404_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3404__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1351__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1315__o).val(), value<1>{0x1u});
	// \src: top.v:6244.20-6244.41
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6244$2130
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3468__o = (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3461__o ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6240$2128 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6248$2132
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3458__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample, not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr));
	// \src: top.v:5163.20-5163.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5163$1772
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4259__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4914__q.curr, value<3>{0x5u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7445$2258 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7441$2256
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<23,20>().val(), value<2>{0x3u}) ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:8550.20-8550.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8550$2598
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3071__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1526__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1803__o);
	// \src: top.v:8544.20-8544.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8544$2595
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3062__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1530__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1524__o);
	// \src: top.v:2529.20-2529.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2529$791
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5338__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<6,3>().val(), value<3>{0x6u});
	// \src: top.v:2517.20-2517.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2517$785
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5323__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<6,3>().val(), value<2>{0x2u});
	// \src: top.v:2513.20-2513.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2513$783
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5320__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<6,3>().val(), value<1>{0x1u});
	// \src: top.v:2662.20-2662.43
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2662$835
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5540__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<43,35>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7589$2308 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:7587$2307
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2372__o = (reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<81,78>().val()) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7601$2312 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7599$2311
	p_unity__link__inst_2e_core__inst_2e_answer__valid = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2326__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<26>().val()));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2283$717 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$and$top.v:1353$386 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1351$385 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2281$716
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<92>().val()), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_advance, (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6197__o ? value<1>{0x1u} : value<1>{0u})));
	// \full_case: 1
	// \src: top.v:707.32-707.32|top.v:704.5-709.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4382_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4342__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<1,0>().val(), value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:706.32-706.32|top.v:704.5-709.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4383_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4343__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<1,0>().val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:705.32-705.32|top.v:704.5-709.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4384_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<1,0>().val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:704.19-704.19|top.v:704.5-709.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4385_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<1,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:11365$3070 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9953$2788 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:9951$2787 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9949$2786 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9943$2784 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9941$2783 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:11363$3069
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_advance = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<54>().val()), and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1154__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1157__o), not_u<1>(and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<55>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<56>().val()), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1166__o))));
	// \src: top.v:11548.19-11548.35
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:11548$3103
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n535__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<39>().val(), p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<8>().val());
	// \src: top.v:11866.19-11866.45
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11866$3182
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n875__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<37,26>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1452$405 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4606
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6303__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6260__o.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6296__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6296__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1560$429 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4622
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6391__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6348__o.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6384__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6384__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10678$2960 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10674$2958 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10670$2956 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10666$2954
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1804__o = or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1698__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1794__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1797__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1701__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1803__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10193$2835 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$add$top.v:10189$2834
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<52>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<49,46>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<49,46>().val());
	// \src: top.v:10384.20-10384.35
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10384$2863
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1482__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left);
	// \src: top.v:10509.20-10509.42
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$add$top.v:10509$2908
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1643__o = add_uu<9>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<117,109>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10380$2861 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10375$2860 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3337
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1478__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o) ? value<11>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<119>().concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3338__CMP ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<118>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<117,109>()).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:9802$2735 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9800$2734 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9798$2733
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1019__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<53,50>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<53,50>().val(), value<3>{0x6u}));
	// \src: top.v:9784.19-9784.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:9784$2728
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n999__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<53,50>().val(), value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:10275.37-10275.37|top.v:10269.5-10278.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3380_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3380__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:10287.37-10287.37|top.v:10282.5-10291.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3377_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3377__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10299.37-10299.37|top.v:10295.5-10304.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3373_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3373__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10311.37-10311.37|top.v:10308.5-10317.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3368_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3368__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10323.37-10323.37|top.v:10321.5-10330.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3362_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3362__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:10335.37-10335.37|top.v:10334.5-10343.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3355_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3355__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1432__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1428__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1413__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1409__o).val(), value<6>{0x20u});
	// \src: top.v:10146.20-10146.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10146$2827
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1367__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<4,0>().val(), value<5>{0x11u});
	// \src: top.v:10117.20-10117.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10117$2820
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1339__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<4,0>().val(), value<3>{0x4u});
	// \src: top.v:10088.20-10088.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10088$2813
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1309__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<4,0>().val());
	// \src: top.v:10067.20-10067.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10067$2808
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1290__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<4,0>().val(), value<5>{0x10u});
	// \src: top.v:6246.20-6246.37
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6246$2131
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3458__o, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3468__o);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5127$1755 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5125$1754 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5123$1753
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4207__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr.slice<1>().val(), (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4915__q.curr, value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u}));
	// \src: top.v:6266.20-6266.34
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:6266$2141
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3489__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.curr, value<2>{0x2u});
	// \src: top.v:5143.20-5143.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5143$1762
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4225__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4915__q.curr, value<2>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7487$2271 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7485$2270
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2254__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked, not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<65>().val()));
	// \full_case: 1
	// \src: top.v:8604.33-8604.33|top.v:8602.5-8607.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3602_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3602__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1701__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3071__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3062__o).val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8528$2588 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3673 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3670 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3659
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3051__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<137>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<17,3>().concat(value<3>{0x7u}).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3660__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<46,45>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3637__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3028__o.slice<17,16>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<17,16>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3637__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3028__o.slice<15,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<15,3>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3674__CMP ? value<3>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3641__CMP ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2583__o_5b_1_3a_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3642__CMP ? value<3>{0x3u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3677__CMP ? value<3>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3635__CMP ? value<3>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3628__CMP ? value<2>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2654__o_5b_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3637__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3028__o.slice<2,0>().val() : value<3>{0x7u})))))))).val());
	// \src: top.v:8028.20-8028.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$add$top.v:8028$2443
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2719__o = add_uu<12>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<14,3>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8020$2441 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3634 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7872$2416 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7867$2414 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7863$2412
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2714__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<137>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<68,66>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3635__CMP ? value<3>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3628__CMP ? (p_unity__link__inst_2e_core__inst_2e_group__is__set.curr ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1851__o ? value<3>{0x1u} : value<2>{0x1u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1853__o ? value<1>{0u} : value<1>{0x1u})).val()) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<68,66>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3637__CMP ? value<3>{0x4u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<68,66>().val()))));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8017$2440 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3640 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7794$2380
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2712__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<137>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<64>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3641__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2588__o ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3642__CMP ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<64>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8022$2442 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3627 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7840$2402 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7881$2420 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7874$2417 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7836$2400
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2715__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<137>().val() ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2559__o_5b_2_3a_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3628__CMP ? (and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2562__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_group__is__set.curr)), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2562__o) ? value<4>{0x6u} : value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2559__o_5b_2_3a_0_5d_).val()) : value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2559__o_5b_2_3a_0_5d_).val()));
	// \src: top.v:2537.20-2537.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2537$795
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5344__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<6,3>().val(), value<2>{0x3u});
	// \src: top.v:2621.20-2621.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2621$827
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5492__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<6,3>().val(), value<4>{0xbu});
	// \src: top.v:2617.20-2617.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2617$825
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5483__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<6,3>().val(), value<4>{0xau});
	// \src: top.v:2613.20-2613.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2613$823
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5474__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<6,3>().val(), value<4>{0x9u});
	// \src: top.v:2609.20-2609.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2609$821
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5465__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<6,3>().val(), value<4>{0x8u});
	// \src: top.v:2601.20-2601.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2601$817
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5447__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5323__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5338__o);
	// \src: top.v:2593.20-2593.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2593$813
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5435__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5320__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5335__o);
	// \src: top.v:2664.20-2664.45
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2664$836
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5544__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5540__o ? value<3>{0u} : value<3>{0x5u});
	// \src: top.v:7619.20-7619.28
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7619$2314
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2398__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2372__o);
	// \src: top.v:2672.20-2672.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2672$840
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5548__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5540__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5162__o);
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2291$720 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2289$719
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5087__o = and_uu<1>((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5079__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance);
	// \full_case: 1
	// \src: top.v:747.32-747.32|top.v:744.5-749.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4362_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4337__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<3,2>().val(), value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:746.32-746.32|top.v:744.5-749.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4363_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4338__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<3,2>().val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:745.32-745.32|top.v:744.5-749.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4364_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4339__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<3,2>().val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:744.19-744.19|top.v:744.5-749.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4365_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4340__CMP = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr.slice<3,2>().val());
	// \src: top.v:11552.19-11552.41
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11552$3105
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n544__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<7,0>().val(), value<4>{0xdu});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10778$2994 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10774$2992
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1901__o = or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1895__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1698__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1701__o);
	// \full_case: 1
	// \src: top.v:10159.19-10159.19|top.v:10159.5-10165.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3395_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3395__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1367__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1339__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1309__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1290__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:10160.34-10160.34|top.v:10159.5-10165.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3394_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3394__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1367__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1339__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1309__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1290__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:10161.34-10161.34|top.v:10159.5-10165.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3393_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3393__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1367__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1339__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1309__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1290__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:10162.34-10162.34|top.v:10159.5-10165.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3392_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3392__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1367__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1339__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1309__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1290__o).val(), value<1>{0x1u});
	// \src: top.v:6268.20-6268.41
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6268$2142
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3496__o = (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3489__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:8570.33-8570.33|top.v:8568.5-8573.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3615
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3081__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3602__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3051__o.slice<17,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<17,3>().val());
	// \full_case: 1
	// \src: top.v:8203.38-8203.38|top.v:8202.5-8212.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3719
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2699__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3660__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<46,45>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3637__CMP ? value<2>{0x2u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<17,16>().val()));
	// \full_case: 1
	// \src: top.v:7920.38-7920.38|top.v:7913.5-7923.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3793
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2693__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3674__CMP ? value<3>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3641__CMP ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2583__o_5b_1_3a_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3642__CMP ? value<3>{0x3u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3677__CMP ? value<3>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3635__CMP ? value<3>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3628__CMP ? value<2>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2654__o_5b_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3637__CMP ? value<3>{0x6u} : value<3>{0x7u})))))));
	// \src: top.v:2668.20-2668.46
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2668$838
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5546__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<10>().val() ? value<3>{0x4u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5544__o);
	// \src: top.v:2670.20-2670.51
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2670$839
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5547__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<10>().val() ? value<3>{0x1u} : value<3>{0x7u});
	// \src: top.v:2832.20-2832.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2832$898
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5753__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<2,0>().val(), value<3>{0x6u});
	// \src: top.v:5371.20-5371.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5371$1854
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4538__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<68,66>().val(), value<2>{0x2u});
	// \src: top.v:5283.20-5283.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5283$1819
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4431__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<68,66>().val(), value<3>{0x4u});
	// \src: top.v:12071.19-12071.38
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12071$3211
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o = and_uu<1>(p_in__valid, p_in__ready.curr);
	// cells $flatten\unity_link_inst.\core_inst.\rx_register_inst.$or$top.v:11959$3201 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11371$3072 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:11369$3071 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$not$top.v:11961$3202
	p_unity__link__inst_2e_core__inst_2e_fifo__out__ready = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_character__valid.curr), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_advance, not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<41>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11568$3109 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:11562$3107 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11566$3108
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n559__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<37,26>().val(), value<12>{0x801u}), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n535__o));
	// \src: top.v:11507.19-11507.39
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11507$3096
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n504__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<16>().val() ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11505$3095 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11502$3094 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$4578
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n503__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<16>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n466__o_5b_2_3a_0_5d_.slice<2>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n473__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n480__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n487__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n494__o_5b_2_3a_0_5d_.slice<2>()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n459__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n494__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n494__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val())).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<25,18>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1462$407 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4608
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6310__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6268__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6303__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6303__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1570$431 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4624
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6398__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6356__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6391__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6391__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10591$2930 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10579$2926 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10573$2924 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10567$2922 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10563$2921 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10577$2925
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1703__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1702__o, and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<6>().val()), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<118>().val(), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<11,8>().val(), value<3>{0x4u})))));
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3458 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3459_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3460_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9782$2727 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$le$top.v:9780$2726 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:9796$2732 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9794$2731 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ge$top.v:9788$2729 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$le$top.v:9792$2730
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1019__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n999__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<49,46>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1019__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n999__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<49,46>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<49,46>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u}));
	// \src: top.v:10559.20-10559.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10559$2920
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1682__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1166__o, p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<56>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5179$1779 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5175$1778 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5173$1777 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5171$1776
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4281__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample, (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr) ? value<1>{0x1u} : value<1>{0u})), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr.slice<3>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5169$1775 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5167$1774 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5165$1773
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4268__o = and_uu<1>(and_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4259__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4207__o), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room.curr);
	// \src: top.v:6270.20-6270.40
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6270$2143
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3497__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3496__o, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr);
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2417$761 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2415$760 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2413$759 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2411$758 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2405$756 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2395$753 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2393$752 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2391$751 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2385$749 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2379$747 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2369$744 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2367$743 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2361$741 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:2365$742
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance, or_uu<1>(or_uu<1>((and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<43,35>().val(), value<1>{0x1u}), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5140__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5137__o)) ? value<1>{0x1u} : value<1>{0u}), (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5166__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5162__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5140__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5156__o))) ? value<1>{0x1u} : value<1>{0u})), (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5166__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5140__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5179__o)) ? value<1>{0x1u} : value<1>{0u})));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7491$2273 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7489$2272 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7481$2269 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7479$2268
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word = and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<54,47>().val(), value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u}), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2254__o));
	// \src: top.v:5446.20-5446.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5446$1886
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3562__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_access__failure.curr);
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7475$2267 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7473$2266
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2229__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2217__o) ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:7451.20-7451.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7451$2259
	p_unity__link__inst_2e_core__inst_2e_access__write = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<22>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<65>().val());
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6278$2147 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6276$2146
	p_unity__link__inst_2e_core__inst_2e_access__done = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3496__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr));
	// \src: top.v:1042.20-1042.39
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1042$328
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6498__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<25>().val(), p_unity__link__inst_2e_core__inst_2e_sent__ready.curr);
	// \src: top.v:2648.20-2648.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2648$833
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5519__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<7,3>().val(), value<4>{0xeu});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2519$786 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2515$784 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2511$782
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5324__o = or_uu<1>(or_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<6,3>().val()), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5320__o), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5323__o);
	// \src: top.v:2555.20-2555.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2555$804
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5381__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<6,3>().val(), value<4>{0xfu});
	// \src: top.v:2551.20-2551.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2551$802
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5372__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<6,3>().val(), value<4>{0xeu});
	// \src: top.v:2547.20-2547.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2547$800
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5363__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<6,3>().val(), value<4>{0xdu});
	// \src: top.v:2543.20-2543.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2543$798
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5354__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<6,3>().val(), value<4>{0xcu});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2539$796 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2535$794 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2533$793 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2531$792 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2527$790 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2523$788
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5345__o = or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<6,3>().val(), value<3>{0x4u}), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5335__o), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5338__o), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<6,3>().val(), value<3>{0x7u})), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5344__o);
	// \src: top.v:2492.20-2492.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2492$777
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5295__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<7,3>().val(), value<5>{0x11u});
	// \src: top.v:2490.20-2490.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2490$776
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5291__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<7,3>().val(), value<5>{0x10u});
	// memory \unity_link_inst.core_inst.frame_writer_inst.n6184 read port 0
	auto tmp_0 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<81,76>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_0.valid && "out of bounds read");
	if(tmp_0.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6185__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6184[tmp_0.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6185__data = value<4> {};
	}
	// \full_case: 1
	// \src: top.v:3120.19-3120.19|top.v:3120.5-3125.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4227_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4227__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5753__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5179__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5156__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:3122.33-3122.33|top.v:3120.5-3125.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4225_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4225__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5753__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5179__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5156__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:3121.36-3121.36|top.v:3120.5-3125.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4226_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4226__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5753__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5179__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5156__o).val(), value<2>{0x2u});
	// memory \unity_link_inst.core_inst.frame_writer_inst.n6182 read port 0
	auto tmp_1 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<81,76>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_1.valid && "out of bounds read");
	if(tmp_1.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6183__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6182[tmp_1.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6183__data = value<4> {};
	}
	// memory \unity_link_inst.core_inst.frame_writer_inst.n6180 read port 0
	auto tmp_2 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<81,76>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_2.valid && "out of bounds read");
	if(tmp_2.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6181__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6180[tmp_2.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6181__data = value<4> {};
	}
	// memory \unity_link_inst.core_inst.frame_writer_inst.n6178 read port 0
	auto tmp_3 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<81,76>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_3.valid && "out of bounds read");
	if(tmp_3.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6179__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6178[tmp_3.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6179__data = value<4> {};
	}
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2319$731 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2317$730 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2315$729 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2311$728
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5109__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5087__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available.curr), not_u<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<82>().val(), p_unity__link__inst_2e_core__inst_2e_answer__valid)));
	// \src: top.v:2699.20-2699.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2699$853
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5563__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<2,0>().val(), value<1>{0x1u});
	// \src: top.v:2818.20-2818.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2818$895
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5725__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<2,0>().val(), value<2>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4868$1665 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4862$1662 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4860$1661 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:325$64 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:323$63 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:321$62 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4858$1660 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4856$1659
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3858__o = and_uu<1>(and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4924__q.curr, not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3843__o)), not_u<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr, (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr) ? value<1>{0x1u} : value<1>{0u})))), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3842__o);
	// \src: top.v:5440.20-5440.40
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5440$1883
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4592__o = add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4932__q.curr, value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:5382.19-5382.19|top.v:5382.5-5386.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4074_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4074__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4538__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4431__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:5383.32-5383.32|top.v:5382.5-5386.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4073_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4073__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4538__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4431__o).val(), value<1>{0x1u});
	// \src: top.v:5225.20-5225.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5225$1793
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4352__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4914__q.curr, value<4>{0x8u});
	// \src: top.v:12073.19-12073.40
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12073$3212
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr, p_unity__link__inst_2e_core__inst_2e_fifo__out__ready);
	// \src: top.v:12087.19-12087.40
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$eq$top.v:12087$3219
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n276__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11738$3156 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11730$3154 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11712$3150 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11710$3149 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11708$3148 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11692$3145 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11678$3141 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11638$3129 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11632$3128 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11618$3124 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3297 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3298_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3299_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11588$3114 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:11586$3113 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11602$3119 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11600$3118 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ge$top.v:11594$3116 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:11598$3117 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11630$3127 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11628$3126 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$add$top.v:11624$3125 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3293 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3294_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$3295_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11648$3131 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:11646$3130 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11662$3136 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11660$3135 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ge$top.v:11654$3133 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:11658$3134 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11690$3144 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11688$3143 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$add$top.v:11684$3142
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n767__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n559__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<61,56>().concat(value<2>{0u}).val() : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n544__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<61,56>().concat(value<2>{0u}).val() : value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n535__o ? value<4>{0x9u} : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<38>().val() ? value<4>{0x7u} : value<3>{0u}.concat((and_uu<1>(eq_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<6>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<3,0>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<3,0>().val()), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<25,22>().val()), and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n698__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n678__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<3,0>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n698__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n678__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<3,0>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<3,0>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<16>().val(), and_uu<1>(eq_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<14>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<11,8>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<11,8>().val()), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<21,18>().val()), and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n632__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n612__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<11,8>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n632__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n612__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<11,8>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<11,8>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<17>().val()))))) ? value<1>{0u} : value<1>{0x1u})).val()))).concat(value<3>{0x3u}).val()));
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:11554$3106 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11550$3104
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n545__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<7,0>().val(), value<4>{0xau}), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n544__o);
	// \src: top.v:11862.19-11862.43
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11862$3181
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n872__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n775__o ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<53,46>()).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n504__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<7,0>()).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11734$3155 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11719$3151 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11722$3152 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11726$3153
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n764__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n559__o ? value<30>{0x10200400u} : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n544__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<45,42>().val() : value<4>{0x4u}).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n544__o ? value<1>{0x1u} : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n544__o ? value<1>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n535__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<38,16>()).val() : value<25>{0x200400u})).val());
	// \src: top.v:11858.19-11858.43
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11858$3180
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n869__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n775__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<25,0>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n503__o.concat(value<1>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<17>()).concat(p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<7,0>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<15,8>()).val());
	// \src: top.v:1496.20-1496.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1496$416
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6334__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<2,0>().val());
	// \src: top.v:1635.20-1635.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1635$449
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6462__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<2,0>().val(), value<3>{0x4u});
	// \src: top.v:1631.20-1631.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1631$448
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6453__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<2,0>().val(), value<2>{0x3u});
	// \src: top.v:1629.20-1629.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1629$447
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6448__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<2,0>().val(), value<2>{0x2u});
	// \src: top.v:5133.20-5133.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5133$1758
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4218__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3497__o, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5151$1766 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5149$1765 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5147$1764 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5145$1763 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5141$1761 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5139$1760 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5135$1759
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted = and_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<8>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr.slice<4>().val())), (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4225__o ? value<1>{0x1u} : value<1>{0u})), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr));
	// \src: top.v:5207.20-5207.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5207$1784
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4914__q.curr, value<3>{0x7u});
	// \src: top.v:5157.20-5157.39
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5157$1769
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4248__o = add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr, value<1>{0x1u});
	// \src: top.v:1044.20-1044.41
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1044$329
	p_unity__link__inst_2e_core__inst_2e_n198__o = and_uu<1>(p_out__valid.curr, p_out__ready);
	// \src: top.v:1088.20-1088.41
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$eq$top.v:1088$351
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6529__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2638$830 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4253 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4245_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4246_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4247_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4248_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4249_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4250_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4251_CMP0
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5505__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<7>().val() ? value<5>{0u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5492__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5483__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5474__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5465__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5344__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5447__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5435__o).val(), value<1>{0x1u}) ? value<5>{0xdu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5492__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5483__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5474__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5465__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5344__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5447__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5435__o).val(), value<2>{0x2u}) ? value<5>{0x11u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5492__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5483__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5474__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5465__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5344__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5447__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5435__o).val(), value<3>{0x4u}) ? value<5>{0xbu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5492__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5483__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5474__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5465__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5344__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5447__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5435__o).val(), value<4>{0x8u}) ? value<5>{0x13u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5492__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5483__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5474__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5465__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5344__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5447__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5435__o).val(), value<5>{0x10u}) ? value<5>{0xeu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5492__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5483__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5474__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5465__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5344__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5447__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5435__o).val(), value<6>{0x20u}) ? value<5>{0x18u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5492__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5483__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5474__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5465__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5344__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5447__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5435__o).val(), value<7>{0x40u}) ? value<5>{0x10u} : value<5>{0u}))))))));
	// \src: top.v:2644.20-2644.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2644$832
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5514__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<7,3>().val(), value<5>{0x12u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7625$2317 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7623$2316 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7621$2315 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7617$2313
	p_unity__link__inst_2e_core__inst_2e_answer__has__id = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<24>().val(), (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2398__o, eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<23,20>().val(), value<4>{0xfu})) ? value<1>{0x1u} : value<1>{0u}));
	// \full_case: 1
	// \src: top.v:3122.33-3122.33|top.v:3120.5-3125.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4224
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6056__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4225__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<22,19>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4226__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<34,31>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4227__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6185__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<75,72>().val())));
	// \full_case: 1
	// \src: top.v:3022.33-3022.33|top.v:3020.5-3025.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4229
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5952__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4225__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<22,19>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4226__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<34,31>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4227__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6183__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<75,72>().val())));
	// \full_case: 1
	// \src: top.v:2936.33-2936.33|top.v:2934.5-2939.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4234
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5859__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4225__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<22,19>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4226__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<34,31>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4227__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6181__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<75,72>().val())));
	// \full_case: 1
	// \src: top.v:2840.33-2840.33|top.v:2838.5-2843.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4239
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5756__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4225__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<22,19>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4226__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<34,31>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4227__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6179__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<75,72>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2301$724 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2299$723 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2297$722 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2293$721
	p_unity__link__inst_2e_core__inst_2e_answer__taken = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5087__o, p_unity__link__inst_2e_core__inst_2e_answer__valid), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<82>().val(), not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available.curr)));
	// \src: top.v:2451.20-2451.51
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2451$766
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5257__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5109__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6177__q.curr.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6177__q.curr.slice<15,7>()).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<75,35>().val());
	// \full_case: 1
	// \src: top.v:3372.37-3372.37|top.v:3368.5-3377.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4092_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5753__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5137__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5179__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5156__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5725__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5563__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5079__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:3373.37-3373.37|top.v:3368.5-3377.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4091_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4091__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5753__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5137__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5179__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5156__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5725__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5563__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5079__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:3368.19-3368.19|top.v:3368.5-3377.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4096_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4096__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5753__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5137__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5179__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5156__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5725__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5563__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5079__o).val(), value<7>{0x40u});
	// \full_case: 1
	// \src: top.v:3369.37-3369.37|top.v:3368.5-3377.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4095_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5753__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5137__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5179__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5156__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5725__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5563__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5079__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:3370.37-3370.37|top.v:3368.5-3377.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4094_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4094__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5753__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5137__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5179__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5156__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5725__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5563__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5079__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:3371.37-3371.37|top.v:3368.5-3377.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4093_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4093__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5753__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5137__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5179__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5156__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5725__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5563__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5079__o).val(), value<4>{0x8u});
	// \src: top.v:4870.20-4870.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4870$1666
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3858__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4926__q.curr);
	// \src: top.v:4906.20-4906.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4906$1681
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3903__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr, value<4>{0x8u});
	// \src: top.v:4901.20-4901.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4901$1679
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3898__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr, value<4>{0x9u});
	// \src: top.v:4931.20-4931.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4931$1691
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr, value<2>{0x3u});
	// \src: top.v:4896.20-4896.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4896$1677
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3893__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr, value<4>{0xau});
	// \src: top.v:4926.20-4926.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4926$1689
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3923__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr, value<3>{0x4u});
	// \src: top.v:4891.20-4891.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4891$1675
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3888__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr, value<4>{0xbu});
	// \src: top.v:4921.20-4921.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4921$1687
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3918__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr, value<3>{0x5u});
	// \src: top.v:4886.20-4886.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4886$1673
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3883__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr, value<4>{0xcu});
	// \src: top.v:4916.20-4916.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4916$1685
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3913__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr, value<3>{0x6u});
	// \src: top.v:4947.20-4947.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4947$1697
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3943__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr);
	// \src: top.v:4881.20-4881.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4881$1671
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3878__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr, value<4>{0xdu});
	// \src: top.v:4941.20-4941.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4941$1695
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3938__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr, value<1>{0x1u});
	// \src: top.v:4911.20-4911.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4911$1683
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3908__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr, value<3>{0x7u});
	// \src: top.v:4936.20-4936.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4936$1693
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3933__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr, value<2>{0x2u});
	// \src: top.v:4876.20-4876.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4876$1669
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3873__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr, value<4>{0xeu});
	// \src: top.v:4872.20-4872.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:4872$1667
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3867__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr, value<4>{0xfu});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5553$1932 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5551$1931
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4723__o = (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5548$1930 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5545$1929
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4718__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr, value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5543$1928 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5540$1927
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4712__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr, value<2>{0x2u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5538$1926 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5535$1925
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4706__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr, value<2>{0x3u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5533$1924 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5530$1923
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4700__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr, value<3>{0x4u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5528$1922 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5525$1921
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4694__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr, value<3>{0x5u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5523$1920 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5520$1919
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4688__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr, value<3>{0x6u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5518$1918 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5515$1917
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4682__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr, value<3>{0x7u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5513$1916 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5510$1915
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4676__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr, value<4>{0x8u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5508$1914 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5505$1913
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4670__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr, value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5503$1912 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5500$1911
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4664__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr, value<4>{0xau}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5498$1910 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5495$1909
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4658__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr, value<4>{0xbu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5493$1908 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5490$1907
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4652__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr, value<4>{0xcu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5488$1906 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5485$1905
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4646__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr, value<4>{0xdu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5483$1904 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5480$1903
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4640__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr, value<4>{0xeu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5478$1902 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5476$1901
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4633__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr, value<4>{0xfu}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4958$1702 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4956$1701
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3858__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4926__q.curr));
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:306$58 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:304$57 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ne$top.v:302$56 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:300$55 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4361 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4366 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4371 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4376 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4381
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counts = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr, (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4337__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4342__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr.slice<15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4343__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr.slice<14>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr.slice<13>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr.slice<12>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4338__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4342__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr.slice<11>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4343__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr.slice<10>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr.slice<9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr.slice<8>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4339__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4342__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr.slice<7>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4343__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr.slice<6>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr.slice<5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr.slice<4>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4340__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4342__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr.slice<3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4343__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr.slice<2>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr.slice<1>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr.slice<0>().val() : value<1>{0u})))) : value<1>{0u}))))), (reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor.curr) ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12113$3232 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$not$top.v:12111$3231
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o));
	// \src: top.v:11395.19-11395.34
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:11395$3074
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n395__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<17,16>().val());
	// \full_case: 1
	// \src: top.v:1712.19-1712.19|top.v:1712.5-1719.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4279_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4279__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6462__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6453__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6448__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6197__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6334__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:1713.32-1713.32|top.v:1712.5-1719.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4278_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4278__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6462__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6453__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6448__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6197__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6334__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:1714.32-1714.32|top.v:1712.5-1719.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4277_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4277__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6462__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6453__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6448__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6197__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6334__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:1716.35-1716.35|top.v:1712.5-1719.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4275_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4275__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6462__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6453__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6448__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6197__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6334__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:1715.32-1715.32|top.v:1712.5-1719.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4276_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4276__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6462__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6453__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6448__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6197__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6334__o).val(), value<2>{0x2u});
	// \src: top.v:7507.20-7507.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7507$2280
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10959$3055 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10613$2935
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2065__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1682__o ? value<1>{0x1u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1703__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<116,109>().concat(value<1>{0x1u}).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<128,121>().concat(value<1>{0u}).val())).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<129,121>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10553$2918 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10537$2915 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10525$2912 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3317 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3318_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3319_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3320_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$sub$top.v:10382$2862 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3382 $auto$opt_reduce.cc:131:opt_pmux$4728 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10543$2916 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3379 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3376 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3372 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3367 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3361 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3354 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3346 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10245$2845 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10517$2910 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10527$2913 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10512$2909 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10531$2914 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10521$2911
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1679__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<128,121>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<119,8>()).val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1482__o ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<116,109>().concat(value<1>{0x1u}).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<128,121>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<128,121>().concat(value<1>{0u}).val()).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1478__o.slice<10>()).concat((and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1446__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1482__o) ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<117>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1478__o.slice<8,0>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1643__o)).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1478__o.slice<9,0>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3338__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<118>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<104,77>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : value<28>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<108,77>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3355__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<72,61>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<76,61>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3362__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<56,53>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<60,53>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3368__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<52,45>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3373__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<40,37>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,37>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3377__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<32,29>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<36,29>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3380__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<24,17>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1404__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<28,17>().val())).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<128,121>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<119,17>()).val()).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3338__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3355__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3362__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3368__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3373__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3377__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3380__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<16>().val() : value<1>{0x1u}).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1482__o ? value<1>{0u}.concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1624__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1621__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1618__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1612__o).val(), value<1>{0x1u}) ? value<3>{0x2u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1624__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1621__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1618__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1612__o).val(), value<3>{0x4u}) ? value<3>{0x7u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1624__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1621__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1618__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1612__o).val(), value<4>{0x8u}) ? value<3>{0x3u} : value<3>{0x1u})))).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1601__o).val() : sub_uu<4>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left, value<1>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field).val())).val() : value<1>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field).val())).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$and$top.v:916$312 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$not$top.v:914$311 $flatten\unity_link_inst.\core_inst.$or$top.v:13012$3280 $flatten\unity_link_inst.\core_inst.$or$top.v:13010$3279 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$or$top.v:1369$389 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1367$388 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ne$top.v:1365$387 $flatten\unity_link_inst.\core_inst.$or$top.v:13008$3278 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2351$738 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2349$737 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:2347$736 $flatten\unity_link_inst.\core_inst.$or$top.v:13006$3277 $flatten\unity_link_inst.\core_inst.$or$top.v:13004$3276 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10009$2795 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10007$2794 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10005$2793 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:10003$2792 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:9999$2791 $flatten\unity_link_inst.\core_inst.$or$top.v:13002$3275 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:11389$3073 $flatten\unity_link_inst.\core_inst.$or$top.v:13000$3274
	p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6607__o = and_uu<1>(not_u<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr, p_unity__link__inst_2e_core__inst_2e_character__valid.curr), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<40>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<54>().val())), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<130>().val(), (or_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<4,0>().val(), value<5>{0x10u}), reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<11,8>().val())) ? value<1>{0x1u} : value<1>{0u}))), p_unity__link__inst_2e_core__inst_2e_hold), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<92>().val(), (reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<2,0>().val()) ? value<1>{0x1u} : value<1>{0u}))), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<25>().val(), (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<2,0>().val(), value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u}))), p_out__valid.curr)), p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6637__q.curr);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5201$1781 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5199$1780
	p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write = or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4268__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4281__o), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4218__o);
	// \src: top.v:5209.20-5209.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5209$1785
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4326__o = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:5221.20-5221.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5221$1791
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4342__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4914__q.curr, value<4>{0x9u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7503$2279 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7501$2278
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__done, (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3562__o ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8665$2625 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8650$2619 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8271$2513 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3730 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8623$2610 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8614$2607 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3618 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3620_CMP0 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8627$2611 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8630$2612 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8634$2613 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8012$2438 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3790
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3127__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<18>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<137>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<17,16>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2719__o).concat(value<3>{0x7u}).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2699__o.concat(value<1>{0u}).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3637__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<28,17>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2719__o)).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2693__o).val()) : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<17,16>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3081__o.slice<14,13>().val()).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19>().val() ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3081__o.slice<12>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<14,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3081__o.slice<11,0>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val() : value<3>{0x7u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3602__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3051__o.slice<2,0>().val() : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1701__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3071__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3062__o).val(), value<3>{0x4u}) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val() : value<3>{0x7u})))).val()) : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<137>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<17,3>().concat(value<3>{0x7u}).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2699__o.concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3637__CMP ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<28,17>()).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<15,3>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2693__o).val()));
	// \src: top.v:7767.20-7767.44
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:7767$2367
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2542__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<136,133>().val());
	// \src: top.v:8850.20-8850.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8850$2684
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val(), value<3>{0x5u});
	// \src: top.v:8819.20-8819.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8819$2675
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val(), value<2>{0x3u});
	// \src: top.v:8727.20-8727.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8727$2646
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val(), value<2>{0x2u});
	// \src: top.v:8725.20-8725.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8725$2645
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6264$2140 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6258$2137 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6256$2136 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6254$2135 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6252$2134
	p_unity__link__inst_2e_core__inst_2e_access__granted = and_uu<1>(and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<64>().val(), not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3458__o)), not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.curr)), p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3468__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7545$2295 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7543$2294 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7497$2276 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7495$2275 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7493$2274
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2315__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__done, (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_access__failure.curr) ? value<1>{0x1u} : value<1>{0u})), not_u<1>(p_unity__link__inst_2e_core__inst_2e_access__write));
	// \src: top.v:6320.20-6320.48
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:6320$2168
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3541__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3650__q.curr);
	// \src: top.v:6340.20-6340.34
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:6340$2178
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3560__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.curr, value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7525$2286 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7523$2285 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7521$2284
	p_unity__link__inst_2e_core__inst_2e_access__more = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue));
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1084$349 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$not$top.v:1082$348
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6547__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_n198__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6498__o));
	// \src: top.v:2640.20-2640.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:2640$831
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5507__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5505__o);
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2686$847 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2680$844 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2674$841
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5555__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5514__o ? value<3>{0x5u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5519__o ? value<3>{0x6u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<9>().val() ? value<3>{0x3u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5546__o)));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:3088$958 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:3081$955
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6017__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<43,35>().val(), value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5140__o);
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2688$848 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2682$845 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2676$842
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5556__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5514__o ? value<6>{0x3u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5519__o ? value<6>{0x3fu} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<9>().val() ? value<2>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<26,23>()).val() : value<3>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5547__o_5b_2_3a_0_5d_).val())));
	// \src: top.v:2883.20-2883.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$sub$top.v:2883$907
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5796__o = sub_uu<6>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<81,76>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2690$849 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2684$846 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2678$843 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2666$837
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5557__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5514__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5519__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<9>().val() ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5548__o ? value<1>{0x1u} : value<1>{0u}))));
	// \full_case: 1
	// \src: top.v:3374.37-3374.37|top.v:3368.5-3377.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4090_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4090__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5753__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5137__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5179__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5156__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5725__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5563__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5079__o).val(), value<1>{0x1u});
	// cell $auto$opt_reduce.cc:131:opt_pmux$4740
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4689 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4091__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP).val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$4750
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4739 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4093__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4094__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4096__CMP).val());
	// \src: top.v:4952.20-4952.28
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4952$1699
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3946__o = not_u<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr);
	// \src: top.v:5420.20-5420.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5420$1873
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4914__q.curr, value<3>{0x4u});
	// \src: top.v:5418.20-5418.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5418$1872
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4572__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4914__q.curr, value<2>{0x3u});
	// \src: top.v:5416.20-5416.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5416$1871
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4570__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4914__q.curr, value<2>{0x2u});
	// \src: top.v:5406.20-5406.36
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5406$1866
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4559__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4914__q.curr, value<1>{0x1u});
	// \src: top.v:5233.20-5233.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5233$1797
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4364__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<68,66>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5231$1796 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5229$1795 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$or$top.v:293$54 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$or$top.v:291$53 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$or$top.v:289$52 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5227$1794
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out = and_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4352__o ? value<1>{0x1u} : value<1>{0u}), not_u<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6970__q.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6972__q.curr), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick.curr)));
	// \full_case: 1
	// \src: top.v:6058.32-6058.32|top.v:6055.5-6060.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3884_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3884__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<46,45>().val(), value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:6057.32-6057.32|top.v:6055.5-6060.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3885_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3885__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<46,45>().val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6056.32-6056.32|top.v:6055.5-6060.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3886_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3886__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<46,45>().val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:6055.19-6055.19|top.v:6055.5-6060.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3887_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3887__CMP = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<46,45>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:312$61 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:310$60 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:308$59
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counts, (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter.curr, value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1489$413 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1484$412 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:1480$411 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$add$top.v:1476$410 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1472$409 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4610
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6329__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<92>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6282__o_5b_2_3a_0_5d_.slice<2>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6289__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6296__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6303__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6310__o_5b_2_3a_0_5d_.slice<2>()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6275__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6310__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6310__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val())).concat(add_uu<2>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<4,3>().val(), value<1>{0x1u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<4,3>().val(), value<2>{0x2u}) ? value<3>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<2,0>().val())).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<12,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$and$top.v:912$310 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$eq$top.v:910$309
	p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6605__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark.curr, value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left.curr);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3738$1527 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2331$735 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2329$734 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$add$top.v:3736$1526
	p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5026__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5109__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<82>().val())) ? add_uu<11>(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5057__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5057__q.curr);
	// \src: top.v:5223.20-5223.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5223$1792
	p_unity__link__inst_2e_core__inst_2e_group__done = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4342__o ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:8828.20-8828.44
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8828$2678
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3259__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<62,55>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<145,138>().val());
	// \full_case: 1
	// \src: top.v:9050.19-9050.19|top.v:9050.5-9060.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3479_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3479__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o).val(), value<8>{0x80u});
	// \full_case: 1
	// \src: top.v:9051.38-9051.38|top.v:9050.5-9060.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3478_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3478__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o).val(), value<7>{0x40u});
	// \full_case: 1
	// \src: top.v:9052.38-9052.38|top.v:9050.5-9060.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3477_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:9053.38-9053.38|top.v:9050.5-9060.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3476_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3476__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:9054.38-9054.38|top.v:9050.5-9060.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3475_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:9055.38-9055.38|top.v:9050.5-9060.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3474_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:9056.38-9056.38|top.v:9050.5-9060.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3473_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3473__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o).val(), value<2>{0x2u});
	// \src: top.v:8735.20-8735.41
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$add$top.v:8735$2648
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3179__o = add_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<62,55>().val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:9057.38-9057.38|top.v:9050.5-9060.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3472_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3472__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2319__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2348__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3279__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2345__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3249__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3174__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3170__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o).val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\wishbone_master_inst.$and$top.v:12266$3272 $flatten\unity_link_inst.\wishbone_master_inst.$or$top.v:12264$3271
	p_unity__link__inst_2e_bus__done = and_uu<1>(p_wb__stb.curr, or_uu<1>(p_wb__ack, p_wb__err));
	// \src: top.v:6298.20-6298.40
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$or$top.v:6298$2157
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample, p_unity__link__inst_2e_core__inst_2e_access__granted);
	// \full_case: 1
	// \src: top.v:6456.19-6456.19|top.v:6456.5-6461.12
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3817_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3489__o.concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3560__o).concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3461__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:6457.35-6457.35|top.v:6456.5-6461.12
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3816_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3816__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3489__o.concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3560__o).concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3461__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6458.33-6458.33|top.v:6456.5-6461.12
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3815_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3815__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3489__o.concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3560__o).concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3461__o).val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2466$769 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7721$2352 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7713$2350 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2448$765
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5266__o = (p_unity__link__inst_2e_core__inst_2e_answer__taken ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<24>().concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2372__o ? value<5>{0x10u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<82>().val() ? value<5>{0x11u} : value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<23,20>()).val()))).concat(value<3>{0x1u}).val() : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5109__o ? value<9>{0x91u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<8,0>().val()));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2470$770 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:2421$762 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7643$2323 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7639$2321 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7637$2320 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7633$2319 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7723$2353 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7691$2343 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3802 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7683$2341 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7681$2340 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7679$2339 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7677$2338 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7675$2337 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7673$2336 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7671$2335 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7669$2334 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7667$2333 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7665$2332 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7663$2331 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7659$2329 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7655$2327 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7651$2325 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2429$763 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7715$2351 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7725$2354 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7629$2318
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5269__o = (p_unity__link__inst_2e_core__inst_2e_answer__taken ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2372__o ? value<4>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<81,78>()).val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<23>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<52,45>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<145,138>().val())).concat(value<2>{0u}).concat((p_unity__link__inst_2e_core__inst_2e_answer__has__id ? value<2>{0x2u}.concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<82>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<14,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<38,27>().val())).val() : value<2>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<36,29>()).concat(value<4>{0u}).val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2372__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<24>().val() ? value<1>{0u} : (or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<23,20>().val(), value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2229__o), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2214__o), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2217__o), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<23,20>().val(), value<4>{0x8u})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<23,20>().val(), value<4>{0x9u})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<23,20>().val(), value<4>{0xau})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<23,20>().val(), value<4>{0xbu})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<23,20>().val(), value<4>{0xcu})) ? value<1>{0x1u} : value<1>{0u})))).concat(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_answer__has__id, and_uu<1>(and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<24>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<23>().val())), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2398__o))).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<34,9>().val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$4730
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4655 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4091__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4093__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4094__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4096__CMP).val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$4726
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4727 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4091__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4093__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4094__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4096__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2480$773 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2455$767
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5276__o = (p_unity__link__inst_2e_core__inst_2e_answer__taken ? value<2>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5109__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6177__q.curr.slice<6>().concat(value<1>{0x1u}).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<83,82>().val()));
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:4954$1700 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4949$1698 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4944$1696 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4939$1694 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4934$1692 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4929$1690 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4924$1688 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4919$1686 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4914$1684 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4909$1682 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4904$1680 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4899$1678 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4894$1676 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4889$1674 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4884$1672 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4879$1670 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4874$1668
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer = or_uu<16>((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3867__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u}).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3873__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3878__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3883__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3888__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3893__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3898__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3903__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3908__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3913__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3918__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3923__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3933__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3938__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3943__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3860__o : value<1>{0u})).val(), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3946__o);
	// \full_case: 1
	// \src: top.v:5814.40-5814.40|top.v:5806.5-5818.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3942_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3942__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4342__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4352__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4210__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4259__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4572__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4570__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4559__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:5813.40-5813.40|top.v:5806.5-5818.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3943_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4342__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4352__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4210__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4259__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4572__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4570__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4559__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:5812.40-5812.40|top.v:5806.5-5818.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3944_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4342__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4352__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4210__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4259__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4572__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4570__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4559__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:5811.41-5811.41|top.v:5806.5-5818.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3945_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4342__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4352__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4210__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4259__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4572__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4570__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4559__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:5810.41-5810.41|top.v:5806.5-5818.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3946_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4342__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4352__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4210__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4259__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4572__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4570__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4559__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:5809.40-5809.40|top.v:5806.5-5818.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3947_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4342__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4352__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4210__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4259__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4572__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4570__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4559__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<7>{0x40u});
	// \full_case: 1
	// \src: top.v:5808.40-5808.40|top.v:5806.5-5818.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3948_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4342__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4352__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4210__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4259__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4572__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4570__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4559__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<8>{0x80u});
	// \full_case: 1
	// \src: top.v:5807.40-5807.40|top.v:5806.5-5818.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3949_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4342__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4352__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4210__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4259__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4572__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4570__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4559__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<9>{0x100u});
	// \full_case: 1
	// \src: top.v:5806.19-5806.19|top.v:5806.5-5818.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3950_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4342__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4352__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4210__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4259__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4572__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4570__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4559__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<10>{0x200u});
	// \full_case: 1
	// \src: top.v:5815.40-5815.40|top.v:5806.5-5818.12
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3941_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3941__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4342__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4352__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4210__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4259__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4574__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4572__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4570__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4559__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3835__o).val(), value<1>{0x1u});
	// \src: top.v:5070.20-5070.25
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5070$1738
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4108__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<9>().val());
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12103$3227 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$not$top.v:12101$3226
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n286__o = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o), p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o);
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12093$3222 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$or$top.v:12091$3221 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12089$3220 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$eq$top.v:12085$3218
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n279__o = and_uu<1>(or_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o, p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n276__o)), p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o);
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1074$344 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$not$top.v:1072$343
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6539__o = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_n198__o), p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6498__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10990$3063 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7509$2281
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2087__o = and_uu<1>((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2282__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<130>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10986$3062 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9931$2779 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:9925$2776 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10968$3057 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10548$2917 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10167$2830 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3397 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3444 $auto$opt_reduce.cc:131:opt_pmux$4742 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3431 $auto$opt_reduce.cc:131:opt_pmux$4736 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3421 $auto$opt_reduce.cc:131:opt_pmux$4734 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3409 $auto$opt_reduce.cc:131:opt_pmux$4732 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3391 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3435 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3427 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3415 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3403 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10175$2831 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10183$2833 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10181$2832 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10971$3058 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10609$2934 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10955$3054 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10604$2933 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10974$3059 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10978$3060 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10982$3061 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10962$3056 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10951$3053 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:10796$2999 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10949$3052 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10828$3009 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10810$3003 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10800$3000 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10808$3002 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10806$3001 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10826$3008 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10824$3007 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10822$3006 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10816$3004 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10947$3051 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10943$3049 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3301 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3302_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3303_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3304_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10910$3040 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10906$3038 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10902$3036 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10898$3034 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10890$3030 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10904$3037 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10900$3035 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10870$3023 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10892$3031 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10888$3029 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10926$3044 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:10916$3042 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10924$3043 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10760$2987 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3310 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3311_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3312_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3313_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3314_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3315_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10635$2942 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10658$2950 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:10651$2949 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:10647$2947 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:10649$2948 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10715$2971 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10708$2970 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10702$2968 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10696$2966 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:10694$2965 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:10690$2964 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:10688$2963 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:10739$2981 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3306 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3307_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$3308_CMP0
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2085__o = (and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<54>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1154__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1157__o) ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<55>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1682__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<145,130>().val() : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1901__o).val(), value<1>{0x1u}) ? value<8>{0x1u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1907__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1901__o).val(), value<2>{0x2u}) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<116,109>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,37>().val())).concat(((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1804__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<1>{0x1u}) ? or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1760__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1763__o) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1804__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<2>{0x2u}) ? or_uu<1>(and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<2>{0x3u}), gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<117,109>().val(), value<8>{0xffu})), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<119>().val()) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1804__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<3>{0x4u}) ? or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1807__o, reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<60,59>().concat(value<6>{0u}).val())), logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<76,61>().val())), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1760__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1763__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<119>().val()) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1804__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<4>{0x8u}) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1807__o : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1857__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1556__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1804__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1527__o).val(), value<5>{0x10u}) ? gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<52,45>().val(), value<2>{0x2u}) : value<1>{0u}))))) ? value<1>{0x1u} : value<1>{0u})).concat((reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<60,57>().val()) ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<60,57>().val() : (and_uu<1>(not_u<1>(and_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>().val(), value<4>{0xeu}), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1031__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<5>().val())), and_uu<1>(not_u<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<6>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<7>().val())), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<4>().val()))) ? value<2>{0u}.concat(((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<16>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1954__o : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1962__o).val(), value<1>{0x1u}) ? value<1>{0x1u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1962__o).val(), value<2>{0x2u}) ? ((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<16>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1948__o : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1973__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1803__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2006__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1948__o)))) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1973__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1803__o ? eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<117,109>().val(), value<2>{0x2u}) : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2006__o ? eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<117,109>().val(), value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1954__o)))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1445__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1443__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1962__o).val(), value<3>{0x4u}) ? and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<117,109>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<44,37>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<118>().val())) : value<1>{0u})))) ? value<2>{0u} : value<2>{0x3u})).val() : value<4>{0x2u}))).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<61>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<56>()).concat(value<1>{0x1u}).val()).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2065__o.slice<9>()).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<145,129>().val()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<55>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2065__o.slice<8,0>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1679__o.slice<120,112>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<55>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<119>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1679__o.slice<111>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<55>().val() ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1703__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1682__o) ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<117>().val() ? value<1>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<116,109>()).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1643__o)).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<118,109>().val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1679__o.slice<110,101>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<55>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<108,0>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1679__o.slice<100,0>().concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter ? or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<7>().val(), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<51>().val())).concat(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<6>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<51>().val())).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<51>()).concat(((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3392__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3436__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3437__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3438__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3439__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3440__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3441__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3442__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3393__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3428__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3429__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3394__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3416__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3417__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3418__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3419__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3395__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3404__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3405__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3406__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3407__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : value<1>{0x1u})))) ? value<5>{0x1fu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3392__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3436__CMP ? value<5>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3437__CMP ? value<5>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3438__CMP ? value<5>{0xdu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3439__CMP ? value<5>{0xeu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3440__CMP ? value<5>{0xfu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3441__CMP ? value<5>{0xcu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3442__CMP ? value<5>{0x11u} : value<5>{0u}))))))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3393__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3428__CMP ? value<5>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3429__CMP ? value<5>{0x2u} : value<5>{0u})) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3394__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3416__CMP ? value<5>{0x5u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3417__CMP ? value<5>{0x7u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3418__CMP ? value<5>{0x6u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3419__CMP ? value<5>{0x3u} : value<5>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3395__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3404__CMP ? value<5>{0x8u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3405__CMP ? value<5>{0x9u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3406__CMP ? value<5>{0xau} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_3407__CMP ? value<5>{0xbu} : value<5>{0u})))) : value<5>{0u})))))).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<7,0>().val())).val())).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<145,121>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<119,0>()).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$and$top.v:908$308 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$eq$top.v:906$307
	p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6602__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark.curr, value<2>{0x2u}), p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left.curr);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3732$1524 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5219$1790 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5217$1789 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3730$1523 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$add$top.v:3728$1522
	p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5022__o = (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4326__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted)) ? p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.curr : (p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write ? add_uu<11>(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5055__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5055__q.curr));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8705$2638 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8681$2631 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8685$2632
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3154__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<130>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2542__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<17,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3127__o.slice<17,3>().val()).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2542__o ? value<3>{0x7u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3127__o.slice<2,0>().val())).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<17,0>().val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$4712
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4693 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3473__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3476__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3478__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3479__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8708$2639 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8687$2633 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8667$2626
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3156__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<130>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<145,138>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<36,17>()).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<132,131>()).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2542__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<5>().val() ? value<1>{0x1u} : value<1>{0u}))).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<3,0>()).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<54,20>().val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$4706
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4695 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3473__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3476__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3478__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3479__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8815$2673 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8796$2667 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8781$2662 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8771$2659 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8800$2668 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8784$2663
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3245__o = (p_unity__link__inst_2e_core__inst_2e_access__done ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<65>().val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2254__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<65>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2254__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<64>().val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<64>().val())))).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<65,64>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8710$2640 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8690$2634 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8669$2627 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8654$2621 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8639$2615 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3608 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8693$2635 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8671$2628 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8656$2622 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8642$2616 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3605
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3157__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<130>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2542__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<68,66>().val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<18>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2714__o : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<68,66>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3602__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2714__o : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<68,66>().val()))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2714__o)).concat(value<1>{0u}).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2542__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<64>().val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<18>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2712__o : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<64>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3602__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2712__o : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<64>().val()))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2712__o))).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<68,64>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8713$2641 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8696$2636 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8674$2629 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8659$2623 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8644$2617 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3601 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3603_CMP0 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8699$2637 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8677$2630 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8662$2624 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8646$2618 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8619$2609
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3159__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<130>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2542__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<18>().val() ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<15>().val() ? value<1>{0u} : value<1>{0x1u}) : value<1>{0u})) : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2542__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<136,133>().val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<18>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2715__o : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<19>().val() ? value<4>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3602__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2715__o : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1701__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3071__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3062__o).val(), value<2>{0x2u}) ? value<4>{0x8u} : value<4>{0u})))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2715__o))).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<82,78>().val());
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6584$2229 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7565$2302 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7563$2301 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6582$2228 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$add$top.v:6580$2227
	p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3404__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2326__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<26>().val())) ? p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.curr : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2315__o ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3437__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3437__q.curr));
	// cell $auto$opt_reduce.cc:131:opt_pmux$4676
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4677 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3816__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP).val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$4686
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4685 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3815__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1064$339 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$or$top.v:1062$338 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1060$337 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$eq$top.v:1056$335
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6532__o = and_uu<1>(or_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_n198__o, p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6529__o)), p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6498__o);
	// \src: top.v:851.20-851.43
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$eq$top.v:851$300
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6645__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6659__q.curr);
	// cell $auto$opt_reduce.cc:131:opt_pmux$4668
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4667 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3942__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP).val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$4656
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4651 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3942__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP).val());
	// \src: top.v:5249.20-5249.39
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5249$1805
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4394__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4326__o);
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5237$1799 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5235$1798
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4372__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4364__o ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$or$top.v:327$65 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5243$1802 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5241$1801 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5239$1800
	p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6717__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counts, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out, (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<68,66>().val(), value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u})));
	// memory \unity_link_inst.core_inst.rx_fifo_inst.memory read port 0
	auto tmp_4 = memory_index(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n334__q.curr, 0, 256);
	CXXRTL_ASSERT(tmp_4.valid && "out of bounds read");
	if(tmp_4.valid) {
		value<9> tmp_5 = memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory[tmp_4.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_12171_24_3257__DATA = tmp_5;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_12171_24_3257__DATA = value<9> {};
	}
	// \src: top.v:1046.20-1046.51
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1046$330
	p_unity__link__inst_2e_core__inst_2e_tx__entry = (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6594__q.curr ? p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.curr : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6595__data.curr);
	// memory \unity_link_inst.core_inst.tx_fifo_inst.memory read port 0
	auto tmp_6 = memory_index(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6587__q.curr, 0, 256);
	CXXRTL_ASSERT(tmp_6.valid && "out of bounds read");
	if(tmp_6.valid) {
		value<10> tmp_7 = memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory[tmp_6.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_1142_24_374__DATA = tmp_7;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_1142_24_374__DATA = value<10> {};
	}
	// \full_case: 1
	// \src: top.v:9087.9-9087.14|top.v:9087.5-9088.41
	// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procmux$3462
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_9088_24_2706__EN_5b_31_3a_0_5d__24_2712_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<120>().val() ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:12173.9-12173.13|top.v:12173.5-12174.35
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$3282
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_12174_24_3210__EN_5b_8_3a_0_5d__24_3261_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:5965.9-5965.20|top.v:5965.5-5966.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3922
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_state__memory_24_top_2e_v_3a_5966_24_1584__EN_5b_9_3a_0_5d__24_2034_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4394__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:5937.9-5937.23|top.v:5937.5-5938.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3931
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5938_24_1567__EN_5b_13_3a_0_5d__24_2025_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4372__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:5937.9-5937.23|top.v:5937.5-5938.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3937
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5938_24_1567__ADDR_5b_3_3a_0_5d__24_2023 = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4372__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr : value<4>{0u});
	// \full_case: 1
	// \src: top.v:5975.9-5975.19|top.v:5975.5-5976.37
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3913
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_list_24_top_2e_v_3a_5976_24_1585__EN_5b_7_3a_0_5d__24_2043_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<69>().val() ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:1144.9-1144.13|top.v:1144.5-1145.35
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$4326
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_1145_24_327__EN_5b_9_3a_0_5d__24_378_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6498__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:3778.9-3778.14|top.v:3778.5-3779.37
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procmux$4080
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_3779_24_1521__EN_5b_31_3a_0_5d__24_1547_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:6630.9-6630.14|top.v:6630.5-6631.37
	// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procmux$3805
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_6631_24_2226__EN_5b_31_3a_0_5d__24_2252_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2315__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:5985.9-5985.18|top.v:5985.5-5986.41
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3904
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_last_24_top_2e_v_3a_5986_24_1586__EN_5b_31_3a_0_5d__24_2052_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4218__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:635.9-635.22|top.v:635.5-636.44
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4396
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_counters_24_top_2e_v_3a_636_24_34__EN_5b_15_3a_0_5d__24_175_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6717__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:666.9-666.15|top.v:666.5-667.40
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4387
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_losses_24_top_2e_v_3a_667_24_51__EN_5b_7_3a_0_5d__24_186_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due ? value<1>{0x1u} : value<1>{0u});
	// memory \unity_link_inst.core_inst.request_memory_inst.memory read port 0
	auto tmp_8 = memory_index(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<62,55>().val(), 0, 256);
	CXXRTL_ASSERT(tmp_8.valid && "out of bounds read");
	if(tmp_8.valid) {
		value<32> tmp_9 = memory_p_unity__link__inst_2e_core__inst_2e_request__memory__inst_2e_memory[tmp_8.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2166__data_5b_31_3a_0_5d_ = tmp_9;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2166__data_5b_31_3a_0_5d_ = value<32> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_sample_ring_inst.memory read port 0
	auto tmp_10 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5057__q.curr.slice<9,0>().val(), 0, 1024);
	CXXRTL_ASSERT(tmp_10.valid && "out of bounds read");
	if(tmp_10.valid) {
		value<32> tmp_11 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_memory[tmp_10.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_5c_n5062__data_5b_31_3a_0_5d_ = tmp_11;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_5c_n5062__data_5b_31_3a_0_5d_ = value<32> {};
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
	auto tmp_14 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6971__q.curr, 0, 16);
	CXXRTL_ASSERT(tmp_14.valid && "out of bounds read");
	if(tmp_14.valid) {
		value<8> tmp_15 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses[tmp_14.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6996__data_5b_7_3a_0_5d_ = tmp_15;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6996__data_5b_7_3a_0_5d_ = value<8> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.losses read port 0
	auto tmp_16 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr, 0, 16);
	CXXRTL_ASSERT(tmp_16.valid && "out of bounds read");
	if(tmp_16.valid) {
		value<8> tmp_17 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses[tmp_16.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6994__data_5b_7_3a_0_5d_ = tmp_17;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6994__data_5b_7_3a_0_5d_ = value<8> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.counters read port 0
	auto tmp_18 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6971__q.curr, 0, 16);
	CXXRTL_ASSERT(tmp_18.valid && "out of bounds read");
	if(tmp_18.valid) {
		value<16> tmp_19 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters[tmp_18.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6990__data_5b_15_3a_0_5d_ = tmp_19;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6990__data_5b_15_3a_0_5d_ = value<16> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.divisors read port 0
	auto tmp_20 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6971__q.curr, 0, 16);
	CXXRTL_ASSERT(tmp_20.valid && "out of bounds read");
	if(tmp_20.valid) {
		value<16> tmp_21 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors[tmp_20.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6986__data_5b_15_3a_0_5d_ = tmp_21;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6986__data_5b_15_3a_0_5d_ = value<16> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.settings_memory read port 0
	auto tmp_22 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr, 0, 16);
	CXXRTL_ASSERT(tmp_22.valid && "out of bounds read");
	if(tmp_22.valid) {
		value<14> tmp_23 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory[tmp_22.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4944__data_5b_13_3a_0_5d_ = tmp_23;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4944__data_5b_13_3a_0_5d_ = value<14> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.state_memory read port 0
	auto tmp_24 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr, 0, 16);
	CXXRTL_ASSERT(tmp_24.valid && "out of bounds read");
	if(tmp_24.valid) {
		value<10> tmp_25 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory[tmp_24.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4948__data_5b_9_3a_0_5d_ = tmp_25;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4948__data_5b_9_3a_0_5d_ = value<10> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.list read port 0
	auto tmp_26 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr).val(), 0, 4096);
	CXXRTL_ASSERT(tmp_26.valid && "out of bounds read");
	if(tmp_26.valid) {
		value<8> tmp_27 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_list[tmp_26.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4951__data_5b_7_3a_0_5d_ = tmp_27;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4951__data_5b_7_3a_0_5d_ = value<8> {};
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.last read port 0
	auto tmp_28 = memory_index(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4932__q.curr).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<9>()).val(), 0, 8192);
	CXXRTL_ASSERT(tmp_28.valid && "out of bounds read");
	if(tmp_28.valid) {
		value<32> tmp_29 = memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last[tmp_28.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4954__data_5b_31_3a_0_5d_ = tmp_29;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4954__data_5b_31_3a_0_5d_ = value<32> {};
	}
	// memory \unity_link_inst.core_inst.request_memory_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:9087.9-9087.14|top.v:9087.5-9088.41
		// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procmux$3468
		auto tmp_30 = memory_index((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<120>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<128,121>().val() : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_30.valid && "out of bounds write");
		if (tmp_30.valid) {
			// \full_case: 1
			// \src: top.v:9087.9-9087.14|top.v:9087.5-9088.41
			// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procmux$3465
			memory_p_unity__link__inst_2e_core__inst_2e_request__memory__inst_2e_memory.update(tmp_30.index, (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<120>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<108,77>().val() : value<32>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_9088_24_2706__EN_5b_31_3a_0_5d__24_2712_5b_0_5d_.repeat<32>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.rx_fifo_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:12173.9-12173.13|top.v:12173.5-12174.35
		// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$3288
		auto tmp_31 = memory_index((p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o ? p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n333__q.curr : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_31.valid && "out of bounds write");
		if (tmp_31.valid) {
			// \full_case: 1
			// \src: top.v:12173.9-12173.13|top.v:12173.5-12174.35
			// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$3285
			memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory.update(tmp_31.index, (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o ? p_in__lost.concat(p_in__data).val() : value<9>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_12174_24_3210__EN_5b_8_3a_0_5d__24_3261_5b_0_5d_.repeat<9>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.state_memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:5965.9-5965.20|top.v:5965.5-5966.41
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3928
		auto tmp_32 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4394__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr : value<4>{0u}), 0, 16);
		CXXRTL_ASSERT(tmp_32.valid && "out of bounds write");
		if (tmp_32.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3925 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5269$1815 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5263$1812 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5259$1810 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5261$1811 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5267$1814 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5271$1816 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5255$1808 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5257$1809 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5273$1817
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_state__memory.update(tmp_32.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4394__o ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4108__o : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<9>().val()).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<8>().val()) : value<1>{0x1u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4319__o ? (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr) ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4930__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4930__q.curr) : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4364__o ? value<8>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<7,0>().val()))).val() : value<10>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_state__memory_24_top_2e_v_3a_5966_24_1584__EN_5b_9_3a_0_5d__24_2034_5b_0_5d_.repeat<10>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.settings_memory write port 0
	if (posedge_p_clk) {
		auto tmp_33 = memory_index(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5938_24_1567__ADDR_5b_3_3a_0_5d__24_2023, 0, 16);
		CXXRTL_ASSERT(tmp_33.valid && "out of bounds write");
		if (tmp_33.valid) {
			// \full_case: 1
			// \src: top.v:5937.9-5937.23|top.v:5937.5-5938.42
			// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3934
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_settings__memory.update(tmp_33.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4372__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<145,138>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<58,53>()).val() : value<14>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5938_24_1567__EN_5b_13_3a_0_5d__24_2025_5b_0_5d_.repeat<14>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.list write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:5975.9-5975.19|top.v:5975.5-5976.37
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3919
		auto tmp_34 = memory_index((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<69>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<77,70>()).val() : value<12>{0u}), 0, 4096);
		CXXRTL_ASSERT(tmp_34.valid && "out of bounds write");
		if (tmp_34.valid) {
			// \full_case: 1
			// \src: top.v:5975.9-5975.19|top.v:5975.5-5976.37
			// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3916
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_list.update(tmp_34.index, (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<69>().val() ? p_unity__link__inst_2e_core__inst_2e_memory__word.curr.slice<7,0>().val() : value<8>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_list_24_top_2e_v_3a_5976_24_1585__EN_5b_7_3a_0_5d__24_2043_5b_0_5d_.repeat<8>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.tx_fifo_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:1144.9-1144.13|top.v:1144.5-1145.35
		// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$4332
		auto tmp_35 = memory_index((p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6498__o ? p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6586__q.curr : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_35.valid && "out of bounds write");
		if (tmp_35.valid) {
			// \full_case: 1
			// \src: top.v:1144.9-1144.13|top.v:1144.5-1145.35
			// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$4329
			memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory.update(tmp_35.index, (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6498__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<24,15>().val() : value<10>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_1145_24_327__EN_5b_9_3a_0_5d__24_378_5b_0_5d_.repeat<10>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_sample_ring_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:3778.9-3778.14|top.v:3778.5-3779.37
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procmux$4086
		auto tmp_36 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write ? p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5055__q.curr.slice<9,0>().val() : value<10>{0u}), 0, 1024);
		CXXRTL_ASSERT(tmp_36.valid && "out of bounds write");
		if (tmp_36.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procmux$4083 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5203$1782 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5205$1783
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_memory.update(tmp_36.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__ring__write ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4268__o ? value<4>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4930__q.curr).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4938__q.curr).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr.slice<3>()).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr.slice<5>()).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr.slice<2>()).concat(value<4>{0u}).val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4281__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q.curr)) : value<32>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_3779_24_1521__EN_5b_31_3a_0_5d__24_1547_5b_0_5d_.repeat<32>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.response_ring_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:6630.9-6630.14|top.v:6630.5-6631.37
		// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procmux$3811
		auto tmp_37 = memory_index((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2315__o ? p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3437__q.curr.slice<7,0>().val() : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_37.valid && "out of bounds write");
		if (tmp_37.valid) {
			// \full_case: 1
			// \src: top.v:6630.9-6630.14|top.v:6630.5-6631.37
			// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procmux$3808
			memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory.update(tmp_37.index, (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2315__o ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q.curr : value<32>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_6631_24_2226__EN_5b_31_3a_0_5d__24_2252_5b_0_5d_.repeat<32>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.last write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:5985.9-5985.18|top.v:5985.5-5986.41
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3910
		auto tmp_38 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4218__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4932__q.curr).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4108__o).val() : value<13>{0u}), 0, 8192);
		CXXRTL_ASSERT(tmp_38.valid && "out of bounds write");
		if (tmp_38.valid) {
			// \full_case: 1
			// \src: top.v:5985.9-5985.18|top.v:5985.5-5986.41
			// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3907
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last.update(tmp_38.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4218__o ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q.curr : value<32>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_last_24_top_2e_v_3a_5986_24_1586__EN_5b_31_3a_0_5d__24_2052_5b_0_5d_.repeat<32>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.divisors write port 0
	if (posedge_p_clk) {
		auto tmp_39 = memory_index(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5938_24_1567__ADDR_5b_3_3a_0_5d__24_2023, 0, 16);
		CXXRTL_ASSERT(tmp_39.valid && "out of bounds write");
		if (tmp_39.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4408 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5058$1737
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors.update(tmp_39.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4372__o ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<53>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<76,61>().val() : value<16>{0u}) : value<16>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_24_memwr_24__5c_settings__memory_24_top_2e_v_3a_5938_24_1567__EN_5b_13_3a_0_5d__24_2025_5b_0_5d_.repeat<16>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.counters write port 0
	if (posedge_p_clk) {
		// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4402 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:329$66
		auto tmp_40 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6717__o ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr) : value<4>{0u}), 0, 16);
		CXXRTL_ASSERT(tmp_40.valid && "out of bounds write");
		if (tmp_40.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4399 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:335$68 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:337$69 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$sub$top.v:339$70
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_counters.update(tmp_40.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6717__o ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.curr ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor.curr : sub_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter.curr, value<1>{0x1u})) : value<16>{0x1u}) : value<16>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_counters_24_top_2e_v_3a_636_24_34__EN_5b_15_3a_0_5d__24_175_5b_0_5d_.repeat<16>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.with_groups_subscription_manager_inst.timer_inst.losses write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:666.9-666.15|top.v:666.5-667.40
		// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4393
		auto tmp_41 = memory_index((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr : value<4>{0u}), 0, 16);
		CXXRTL_ASSERT(tmp_41.valid && "out of bounds write");
		if (tmp_41.valid) {
			// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4390 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:343$72 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4336 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4341 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4346 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4351 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procmux$4356 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$add$top.v:341$71
			memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_losses.update(tmp_41.index, (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due ? ((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4337__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4342__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4343__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<14>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<13>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<12>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4338__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4342__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<11>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4343__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<10>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<8>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4339__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4342__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<7>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4343__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<6>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<4>().val() : value<1>{0u})))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4340__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4342__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4343__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<2>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4344__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<1>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_procmux_24_4345__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<0>().val() : value<1>{0u})))) : value<1>{0u})))) ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__losses.curr, value<1>{0x1u}) : value<8>{0u}) : value<8>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_24_memwr_24__5c_losses_24_top_2e_v_3a_667_24_51__EN_5b_7_3a_0_5d__24_186_5b_0_5d_.repeat<8>().val(), 0);
		}
	}
	// cells $flatten\unity_link_inst.\with_fifo_fifo_port_inst.$procdff$4413 $flatten\unity_link_inst.\with_fifo_fifo_port_inst.$and$top.v:12212$3266 $flatten\unity_link_inst.\with_fifo_fifo_port_inst.$not$top.v:12210$3265
	if (posedge_p_clk) {
		p_out__flush.next = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_flush.curr, not_u<1>(p_rst));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4424 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12133$3242 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12079$3215 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$add$top.v:12077$3214
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n333__q.next = (p_rst ? value<8>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n245__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n333__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n333__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4423 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12135$3243 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12083$3217 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$add$top.v:12081$3216
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n334__q.next = (p_rst ? value<8>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n334__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n334__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4422 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12137$3244 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12127$3239 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$add$top.v:12105$3228 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12121$3236 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$sub$top.v:12115$3233
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n286__o ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<1>{0x1u}) : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o ? sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4421 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12139$3245 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12129$3240 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12119$3235 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:12123$3237
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n286__o ? value<1>{0x1u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n276__o, p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4420 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12141$3246 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12131$3241 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12109$3230 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$eq$top.v:12107$3229 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12125$3238
	if (posedge_p_clk) {
		p_in__ready.next = (p_rst ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n286__o ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<8>{0xffu}) ? value<1>{0u} : p_in__ready.curr) : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n294__o ? value<1>{0x1u} : p_in__ready.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4419 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12143$3247 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12097$3224
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n279__o ? p_in__lost.concat(p_in__data).val() : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4418 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12145$3248 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12099$3225 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12095$3223
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n341__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n279__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n341__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$4417 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$3290
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n342__data.next = (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n246__o ? i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_12171_24_3257__DATA : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n342__data.curr);
	}
	// cells $flatten\unity_link_inst.\wishbone_master_inst.$or$top.v:12258$3268 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6284$2150 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:6282$2149 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$or$top.v:6280$2148
	p_wb__cyc = or_uu<1>(p_wb__stb.curr, and_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.curr, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q.curr), not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.curr)));
	// cells $flatten\unity_link_inst.\core_inst.\rx_register_inst.$procdff$4426 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:11971$3207 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:11967$3205
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_character__valid.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_fifo__out__ready ? p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr : p_unity__link__inst_2e_core__inst_2e_character__valid.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_register_inst.$procdff$4425 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:11969$3206 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:11965$3204 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:12075$3213
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_character__in.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_fifo__out__ready ? (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n341__q.curr ? p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.curr : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n342__data.curr) : p_unity__link__inst_2e_core__inst_2e_character__in.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procdff$4427 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11925$3198 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11923$3197 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11921$3196 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11523$3097 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11527$3098 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11531$3099 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11535$3100 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11539$3101 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11544$3102 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11410$3077 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11408$3076 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11918$3195 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11890$3189 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11894$3190 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11885$3188 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11879$3186 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$sub$top.v:11873$3184 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11869$3183 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:11881$3187 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11750$3160 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11899$3191 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11903$3192 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11907$3193 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:11912$3194
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.next = (p_rst ? value<62>{0x4000000u,0x1020u} : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_advance ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<41>().val() ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n395__o ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<39>().val() ? value<4>{0x9u} : value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<38>().val() ? value<3>{0x7u} : value<3>{0u})).val())).concat(value<2>{0x3u}).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<61,56>().concat(value<1>{0u}).val()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n395__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n504__o)).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n395__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<53,46>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<7,0>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n395__o ? value<20>{0x40801u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<45,42>().concat(value<1>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<40,26>()).val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n395__o ? value<10>{0u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n503__o.concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<17>()).val())).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<15,8>()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n395__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<7,0>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<15,8>().val())).val() : (p_unity__link__inst_2e_core__inst_2e_character__valid.curr ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n545__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n767__o.slice<7,1>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<61,56>().concat(value<1>{0u}).val()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n545__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n767__o.slice<0>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n872__o.slice<8>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n545__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<53,46>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n872__o.slice<7,0>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n545__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n764__o.slice<29,23>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<45,42>().concat(value<2>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n535__o).val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n545__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n764__o.slice<22,0>().val() : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n775__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<38,26>().val() : (and_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n775__o ? value<1>{0u} : value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n875__o) ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<38>().val()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n875__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<37,26>().val() : sub_uu<12>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<37,26>().val(), value<1>{0x1u}))).val()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n869__o.slice<25,16>()).val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n545__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<15,0>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n869__o.slice<15,0>().val())).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<61,56>().concat(value<2>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<53,42>()).concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr.slice<40,0>()).val())) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n925__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procdff$4511 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1725$458 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1723$457 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4316 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1598$439 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$and$top.v:1592$437 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1594$438 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1627$446 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4309 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$sub$top.v:1620$444 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4302 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1584$434 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1580$433 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$4626 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4295 $auto$opt_reduce.cc:131:opt_pmux$4724 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4288 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1492$414 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1588$435 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1612$443 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$gt$top.v:1604$441 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$add$top.v:1608$442 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4281 $auto$opt_reduce.cc:131:opt_pmux$4674 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$4274 $auto$opt_reduce.cc:131:opt_pmux$4746 $auto$opt_reduce.cc:131:opt_pmux$4672 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:1494$415
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.next = (p_rst ? value<26>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_advance ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4275__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4276__CMP).val()) ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<92>().val() ? value<1>{0x1u} : value<1>{0u}) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4277__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4278__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4279__CMP).val()) ? value<1>{0x1u} : value<1>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4279__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<14,13>().val() : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4275__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4276__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4277__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4278__CMP).val()) ? value<2>{0u} : value<2>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4275__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<92>().val() ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6247__o_5b_6_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<22,15>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4276__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<92>().val() ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<91,84>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<22,15>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4277__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<12,9>().val(), value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<12,9>().val())).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<12,9>()).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4278__CMP ? value<8>{0xdu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4279__CMP ? value<8>{0xau} : value<8>{0u})))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4276__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<96,95>().val() : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4275__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4277__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4278__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4279__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<14,13>().val() : value<2>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4275__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6329__o.slice<12,5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4276__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<92>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6370__o_5b_2_3a_0_5d_.slice<2>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6377__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6384__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6391__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6398__o_5b_2_3a_0_5d_.slice<2>()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6363__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6398__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6398__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val())).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<12,5>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4277__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<8,5>().concat(value<4>{0u}).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4278__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<12,5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4279__CMP ? value<8>{0u} : value<8>{0u})))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4275__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6329__o.slice<4,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4276__CMP ? value<2>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4277__CMP ? sub_uu<2>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<4,3>().val(), value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4278__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<4,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4279__CMP ? value<2>{0u} : value<2>{0u})))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4275__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6329__o.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4276__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<93>().val(), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<92>().val()) ? value<2>{0x1u}.concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<94>().val() ? value<1>{0x1u} : value<1>{0u})).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4277__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6243__o ? value<3>{0x4u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4278__CMP ? value<3>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_4279__CMP ? value<3>{0x1u} : value<3>{0u})))))).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr));
	}
	// \src: top.v:3393.3-3394.28
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procdff$4509
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6177__q.next = p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__word.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4522 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1104$359 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1050$332 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$add$top.v:1048$331
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6586__q.next = (p_rst ? value<8>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6498__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6586__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6586__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4521 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1106$360 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1054$334 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$add$top.v:1052$333
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6587__q.next = (p_rst ? value<8>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_n198__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6587__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6587__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4520 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1108$361 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1098$356 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$add$top.v:1076$345 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1092$353 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$sub$top.v:1086$350
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6539__o ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<1>{0x1u}) : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6547__o ? sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procdff$4428 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11008$3067 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10995$3064 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:10998$3065 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:11001$3066
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.next = (p_rst ? value<146>{0x10u,0u,0u,0u,0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2085__o.slice<145,131>().concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2087__o ? value<2>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2085__o.slice<130,129>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2085__o.slice<128,17>()).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2087__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2085__o.slice<16>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2085__o.slice<15,12>()).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2087__o ? value<12>{0x10u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2085__o.slice<11,0>().val())).val());
	}
	// \src: top.v:9083.3-9085.40
	// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procdff$4432
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_memory__word.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2166__data_5b_31_3a_0_5d_;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$procdff$4523 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:930$319 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:926$317 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:922$315 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:918$313
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_flush.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6602__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6605__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6607__o ? value<1>{0x1u} : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$procdff$4524 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:936$322 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:928$318 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:924$316 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:920$314
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6637__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6602__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6605__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6607__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_n6637__q.curr))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$procdff$4525 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:934$321
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_its__mark.next = (p_rst ? value<2>{0u} : p_unity__link__inst_2e_core__inst_2e_tx__entry.slice<9,8>().val());
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$procdff$4526 $flatten\unity_link_inst.\core_inst.\with_send_immediate_send_immediate_inst.$ternary$top.v:932$320
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__send__immediate__send__immediate__inst_2e_has__left.next = (p_rst ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_n198__o);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4508 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3752$1534
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5055__q.next = (p_rst ? value<11>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5022__o);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4507 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3754$1535 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3734$1525 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5211$1786
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.next = (p_rst ? value<11>{0u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4326__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_accepted) ? p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5022__o : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4506 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3756$1536
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5057__q.next = (p_rst ? value<11>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5026__o);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4505 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3748$1532 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$sub$top.v:3742$1529 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$sub$top.v:3740$1528
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__ring__room.next = (p_rst ? value<11>{0x400u} : sub_uu<11>(value<11>{0x400u}, sub_uu<11>(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5055__q.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5057__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4504 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3750$1533 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ternary$top.v:3746$1531 $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$ne$top.v:3744$1530
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__available.next = (p_rst ? value<1>{0u} : (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_committed.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__sample__ring__inst_2e_n5026__o) ? value<1>{0x1u} : value<1>{0u}));
	}
	// \src: top.v:3774.3-3776.37
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_sample_ring_inst.$procdff$4503
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_sample__word.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__sample__ring__inst_2e__24_0_5c_n5062__data_5b_31_3a_0_5d_;
	}
	// \src: top.v:9068.3-9069.28
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procdff$4433
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.next = p_unity__link__inst_2e_core__inst_2e_memory__word.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procdff$4434 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:9063$2703 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3591 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8720$2643 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8807$2670 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8787$2664 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8775$2660 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8768$2658 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8765$2657 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:8763$2656 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8822$2676 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8838$2680 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8853$2685 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8862$2688 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:8859$2687 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3581 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7747$2362 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7745$2361 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7756$2364 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$sub$top.v:7752$2363 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3571 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3561 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3551 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3541 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8812$2672 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8793$2666 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8778$2661 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8759$2655 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$add$top.v:8756$2654 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$sub$top.v:8750$2652 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3531 $auto$opt_reduce.cc:131:opt_pmux$4704 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8841$2681 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8738$2649 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8731$2647 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7762$2366 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ge$top.v:7760$2365 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3521 $auto$opt_reduce.cc:131:opt_pmux$4702 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8723$2644 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3511 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3501 $auto$opt_reduce.cc:131:opt_pmux$4698 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8844$2682 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3491 $auto$opt_reduce.cc:131:opt_pmux$4696 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8848$2683 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3481 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:8803$2669 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:8817$2674 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$3471
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.next = (p_rst ? value<83>{0xd20000u,0u,0x8u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4693 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<82>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3472__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3159__o.slice<4>().val() : value<1>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed, p_unity__link__inst_2e_core__inst_2e_access__done) ? p_unity__link__inst_2e_core__inst_2e_access__failure.curr : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<81,78>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4695 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<81,78>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3472__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3159__o.slice<3,0>().val() : value<4>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3259__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<77,70>().concat(value<1>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<62,55>().concat(value<1>{0x1u}).val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3472__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3473__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3476__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3478__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3479__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<77,70>().concat(value<1>{0u}).val() : value<9>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3259__o ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<68,66>().val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3473__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3476__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3478__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3479__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<68,66>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3472__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3157__o.slice<4,2>().val() : value<3>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3245__o.slice<1>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4695 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<65>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3472__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3157__o.slice<1>().val() : value<1>{0u})))).concat((reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3476__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3478__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3479__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<64>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3245__o.slice<0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP ? value<1>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3473__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<63>().val() ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<64>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3472__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3157__o.slice<0>().val() : value<1>{0u})))))).concat((ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.curr, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<145,138>().val()) ? value<1>{0x1u} : value<1>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3259__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<62,55>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3179__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<22>().val(), p_unity__link__inst_2e_core__inst_2e_access__granted) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3179__o : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<62,55>().val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3473__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3476__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3478__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3479__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<62,55>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3472__CMP ? value<8>{0u} : value<8>{0u}))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__done ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<54,39>().val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2254__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<54,39>().val() : sub_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<54,47>().val(), value<1>{0x1u}).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<46,39>().val() : add_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<46,39>().val(), value<1>{0x1u}))).val())) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<54,39>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4695 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<54,39>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3472__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3156__o.slice<34,19>().val() : value<16>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4693 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<38,25>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3472__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3156__o.slice<18,5>().val() : value<14>{0u}))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4693 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<24>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3472__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3156__o.slice<4>().val() : value<1>{0u}))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4693 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<23,20>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3472__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3156__o.slice<3,0>().val() : value<4>{0u}))).concat(not_u<1>(sub_uu<12>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<28,17>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<14,3>().val()).slice<11>().val())).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<28,17>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<14,3>().val()) ? value<1>{0x1u} : value<1>{0u})).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4693 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<17,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3472__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3154__o.slice<17,3>().val() : value<15>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3472__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3154__o.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3473__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<63>().val() ? value<3>{0x3u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3474__CMP ? value<3>{0x3u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3475__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__done ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? value<3>{0x7u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2254__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<23,20>().val(), value<3>{0x7u}) ? value<3>{0u} : value<3>{0x7u}) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val()))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3476__CMP ? (p_unity__link__inst_2e_core__inst_2e_group__done ? value<3>{0x5u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3477__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3259__o ? value<3>{0x6u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3478__CMP ? (p_unity__link__inst_2e_core__inst_2e_group__done ? value<3>{0x7u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_3479__CMP ? (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_answer__taken, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<26>().val()) ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<2,0>().val()) : value<3>{0u}))))))))).val());
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4443 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6604$2239
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3437__q.next = (p_rst ? value<9>{0u} : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3404__o);
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4442 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6606$2240 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6586$2230 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7553$2298
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.next = (p_rst ? value<9>{0u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2326__o, p_unity__link__inst_2e_core__inst_2e_answer__taken) ? p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3404__o : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4441 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6608$2241 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6590$2232 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2325$733 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:2323$732 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$add$top.v:6588$2231
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3439__q.next = (p_rst ? value<9>{0u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word, not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<82>().val())) ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3439__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3439__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4440 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:6600$2237 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$sub$top.v:6594$2234 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$sub$top.v:6592$2233
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.next = (p_rst ? value<9>{0x100u} : sub_uu<9>(value<9>{0x100u}, sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3437__q.curr, p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3439__q.curr)));
	}
	// \src: top.v:6626.3-6628.37
	// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$4438
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3444__data_5b_31_3a_0_5d_;
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4456 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6475$2206 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3844 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6312$2164 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6336$2176 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6326$2171
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.next = (p_rst ? value<2>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3815__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o ? value<2>{0x1u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3816__CMP ? (p_unity__link__inst_2e_bus__done ? value<2>{0x2u} : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3541__o ? value<2>{0x2u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3644__q.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP ? value<2>{0u} : value<2>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4455 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6477$2207 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3839 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6292$2154 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6286$2151
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.next = (p_rst ? value<1>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4677 ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3815__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr)) : value<1>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4454 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6479$2208 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3834 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6288$2152 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5161$1771 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5159$1770 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6344$2180 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6350$2183
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3815__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample ? (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4248__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr.slice<13,6>().val()) ? value<1>{0x1u} : value<1>{0u}) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3816__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3562__o) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3646__q.curr) : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4453 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6481$2209 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3829 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6294$2155 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6352$2184 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6346$2181
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3815__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? p_unity__link__inst_2e_core__inst_2e_access__more : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3816__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3562__o ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q.curr : value<1>{0u}) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3647__q.curr) : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4452 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6483$2210 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3824 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6296$2156 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6290$2153 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7527$2287 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6354$2185 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6348$2182
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3815__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__more, or_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__write, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked)) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3816__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3562__o ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr : value<1>{0u}) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_exclusive.curr) : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4451 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6485$2211 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3819 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6338$2177 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6328$2172
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3815__CMP ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3816__CMP ? (p_unity__link__inst_2e_bus__done ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.curr : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3541__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3649__q.curr : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4450 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6487$2212 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3814 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$sub$top.v:6316$2166
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3650__q.next = (p_rst ? value<11>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3815__CMP ? value<11>{0x3ffu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3816__CMP ? sub_uu<11>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3650__q.curr, value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3650__q.curr : value<11>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4449 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6463$2200 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3874 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6330$2173 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6318$2167 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6322$2169
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_access__failure.next = (p_rst ? value<4>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3816__CMP ? (p_unity__link__inst_2e_bus__done ? value<1>{0u}.concat((p_wb__err ? value<3>{0x4u} : value<3>{0u})).val() : value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3541__o ? value<3>{0x5u} : value<3>{0u})).val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4685 ? p_unity__link__inst_2e_core__inst_2e_access__failure.curr : value<4>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4448 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6465$2201 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3869 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6332$2174
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q.next = (p_rst ? value<32>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3816__CMP ? (p_unity__link__inst_2e_bus__done ? p_wb__dat__i : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4685 ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q.curr : value<32>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4447 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6467$2202 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3864 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6304$2160 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6334$2175 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6324$2170
	if (posedge_p_clk) {
		p_wb__stb.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3815__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o ? value<1>{0x1u} : p_wb__stb.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3816__CMP ? (p_unity__link__inst_2e_bus__done ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3541__o ? value<1>{0u} : p_wb__stb.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3817__CMP ? p_wb__stb.curr : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4446 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6469$2203 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3859 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6306$2161 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:6300$2158
	if (posedge_p_clk) {
		p_wb__we.next = (p_rst ? value<1>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4677 ? p_wb__we.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3815__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o ? and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__granted, p_unity__link__inst_2e_core__inst_2e_access__write) : p_wb__we.curr) : value<1>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4445 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6471$2204 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3854 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6308$2162 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6302$2159
	if (posedge_p_clk) {
		p_wb__adr.next = (p_rst ? value<8>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4677 ? p_wb__adr.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3815__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample__address.curr : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<46,39>().val()) : p_wb__adr.curr) : value<8>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$4444 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6473$2205 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$3849 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:6310$2163 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7531$2288 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7463$2263 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7461$2262 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7541$2293 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:7539$2292 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7537$2291 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7535$2290 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7533$2289
	if (posedge_p_clk) {
		p_wb__dat__o.next = (p_rst ? value<32>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4677 ? p_wb__dat__o.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_3815__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o ? ((or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2214__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2217__o) ? value<1>{0x1u} : value<1>{0u}) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.curr : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__masked ? or_uu<32>(and_uu<32>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q.curr, not_u<32>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.curr)), and_uu<32>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<108,77>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.curr)) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<108,77>().val())) : p_wb__dat__o.curr) : value<32>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4519 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1110$362 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1100$357 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1090$352 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:1094$354
	if (posedge_p_clk) {
		p_out__valid.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6539__o ? value<1>{0x1u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6529__o, p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6547__o) ? value<1>{0u} : p_out__valid.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4518 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1112$363 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1102$358 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1080$347 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$eq$top.v:1078$346 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1096$355
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_sent__ready.next = (p_rst ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6539__o ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<8>{0xffu}) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_sent__ready.curr) : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6547__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_sent__ready.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4517 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1114$364 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1068$341
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.next = (p_rst ? value<10>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6532__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n6491__q.curr.slice<24,15>().val() : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4516 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1116$365 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1070$342 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:1066$340
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6594__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6532__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_n198__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6594__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procdff$4510 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3388$998 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3386$997 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4215 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2692$850 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2908$916 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2994$936 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3084$956 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3172$977 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4206 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4197 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4188 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2864$904 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4179 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4170 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2875$906 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4161 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3091$959 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$sub$top.v:3073$953 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2474$771 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7707$2349 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7705$2348 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:7699$2346 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:7697$2345 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7703$2347 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3383$996 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3381$995 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4152 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2478$772 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4143 $auto$opt_reduce.cc:131:opt_pmux$4752 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2996$937 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2910$917 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2695$851 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4134 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4125 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3096$961 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4116 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2571$807 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4270 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4271_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4272_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4262 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4263_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4264_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4265_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4266_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4267_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4268_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2853$902 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:2845$900 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:2849$901 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2949$926 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:2941$924 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:2945$925 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3035$946 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:3027$944 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:3031$945 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3135$970 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:3127$968 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:3131$969 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4107 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4098 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2697$852 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2899$912 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2912$918 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2991$935 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2998$938 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3086$957 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:3174$978 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$4089 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2482$774 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7741$2360 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:7729$2355 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:7739$2359 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:7735$2357 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2459$768 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2441$764
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.next = (p_rst ? value<97>{0u,0u,0u,0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance ? (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4655 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<96,94>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4090__CMP ? (p_unity__link__inst_2e_core__inst_2e_answer__taken ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<17,16>().val(), value<1>{0x1u}) ? value<2>{0x2u} : value<1>{0u}.concat((reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<17,16>().val()) ? value<1>{0x1u} : value<1>{0u})).val()).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<25>()).val() : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5109__o ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6177__q.curr.slice<4>().val() ? value<2>{0x2u} : value<2>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6177__q.curr.slice<5>()).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<96,94>().val())) : value<3>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4090__CMP ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4091__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5507__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5557__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5557__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4093__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5548__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5140__o) ? value<1>{0x1u} : value<1>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4094__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5540__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5140__o) ? value<1>{0x1u} : value<1>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6017__o ? value<1>{0x1u} : value<1>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4096__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5140__o ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})))))))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4655 ? value<1>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4090__CMP ? value<1>{0u} : value<1>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4090__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<91,84>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4091__CMP ? value<2>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<8>()).concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<7>().val() ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5295__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5291__o).val(), value<1>{0x1u}) ? value<5>{0x18u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5295__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5291__o).val(), value<2>{0x2u}) ? value<5>{0xeu} : value<5>{0x10u})) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5381__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5372__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5363__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5354__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5345__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5324__o).val(), value<1>{0x1u}) ? value<5>{0x12u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5381__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5372__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5363__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5354__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5345__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5324__o).val(), value<2>{0x2u}) ? value<5>{0x17u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5381__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5372__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5363__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5354__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5345__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5324__o).val(), value<3>{0x4u}) ? value<5>{0x9u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5381__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5372__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5363__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5354__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5345__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5324__o).val(), value<4>{0x8u}) ? value<5>{0x8u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5381__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5372__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5363__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5354__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5345__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5324__o).val(), value<5>{0x10u}) ? value<5>{0x11u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5381__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5372__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5363__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5354__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5345__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5324__o).val(), value<6>{0x20u}) ? value<5>{0xbu} : value<5>{0x7u})))))))).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? value<2>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5505__o).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4093__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5756__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5756__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5756__o).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4094__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5859__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5859__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5859__o).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5952__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5952__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5952__o).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4096__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6056__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6056__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6056__o).val()) : value<8>{0u})))))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5140__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<83>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4727 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<83>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4090__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5276__o.slice<1>().val() : value<1>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4655 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<82>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4090__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5276__o.slice<0>().val() : value<1>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4096__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5796__o : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4094__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP).val()) ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5140__o ? value<6>{0x7u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5796__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4093__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5140__o ? value<3>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5547__o_5b_2_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5796__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5556__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4091__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5507__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<81,76>().val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5556__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4090__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<81,76>().val() : value<6>{0u}))))))).concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<82>().val() ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6177__q.curr : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4739 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<71,44>().concat(value<4>{0u}).val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4689 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<75,44>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4090__CMP ? (p_unity__link__inst_2e_core__inst_2e_answer__taken ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<75,44>().val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5257__o.slice<40,9>().val()) : value<32>{0u}))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5140__o ? sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<43,35>().val(), value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<43,35>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4727 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<43,35>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4090__CMP ? (p_unity__link__inst_2e_core__inst_2e_answer__taken ? value<1>{0u}.concat((and_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<23,22>().val()), and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<82>().val()), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2398__o)) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<145,138>().val() : value<8>{0u})).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5257__o.slice<8,0>().val()) : value<9>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4090__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5269__o.slice<25,18>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4689 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<34,27>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4739 ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5179__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<30,27>().concat(value<4>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<34,27>().val()) : value<8>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4655 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<26,23>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4090__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5269__o.slice<17,14>().val() : value<4>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4090__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5269__o.slice<13,2>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4689 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<22,11>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4739 ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5156__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<18,11>().concat(value<4>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<22,11>().val()) : value<12>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4655 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<10,9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4090__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5269__o.slice<1,0>().val() : value<2>{0u}))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4655 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<8,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4090__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5266__o.slice<8,3>().val() : value<6>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4090__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5266__o.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4091__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5507__o ? value<3>{0x2u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5555__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4092__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5555__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4093__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5140__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5546__o : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4094__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5140__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5544__o : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4095__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6017__o ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_4096__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n5140__o ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr.slice<2,0>().val()) : value<3>{0u})))))))).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n6176__q.curr));
	}
	// \src: top.v:662.3-664.40
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4532
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6996__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6996__data_5b_7_3a_0_5d_;
	}
	// \src: top.v:659.3-661.37
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4533
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6994__data_5b_7_3a_0_5d_;
	}
	// \src: top.v:631.3-633.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4537
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6990__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6990__data_5b_15_3a_0_5d_;
	}
	// \src: top.v:603.3-605.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4541
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6986__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__5c_timer__inst_2e__24_0_5c_n6986__data_5b_15_3a_0_5d_;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4542 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:540$144 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:537$143 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:530$141 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:528$140 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:535$142 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:526$139 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:519$137 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:517$136 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:524$138 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:515$135 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:508$133 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:506$132 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:513$134 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:504$131 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:497$129 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:495$128 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:502$130 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:493$127 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:486$125 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:484$124 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:491$126 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:482$123 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:475$121 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:473$120 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:480$122 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:471$119 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:464$117 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:462$116 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:469$118 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:460$115 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:453$113 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:451$112 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:458$114 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:449$111 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:442$109 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:440$108 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:447$110 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:438$107 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:431$105 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:429$104 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:436$106 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:427$103 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:420$101 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:418$100 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:425$102 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:416$99 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:409$97 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:407$96 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:414$98 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:405$95 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:398$93 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:396$92 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:403$94 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:394$91 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:387$89 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:385$88 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:392$90 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:383$87 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:376$85 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:374$84 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:381$86 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:372$83 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:365$81 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:363$80 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:370$82
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.next = (p_rst ? value<16>{0u} : (and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xfu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<15>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<15>().val())).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xeu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<14>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<14>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xdu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<13>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<13>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xcu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<12>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<12>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xbu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<11>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<11>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0xau}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<10>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<10>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0x9u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<9>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<9>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<4>{0x8u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<8>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<8>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<3>{0x7u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<7>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<7>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<3>{0x6u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<6>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<6>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<3>{0x5u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<5>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<5>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<3>{0x4u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<4>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<4>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<2>{0x3u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<3>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<3>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<2>{0x2u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<2>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<2>().val()))).concat((and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr, value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<1>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<1>().val()))).concat((and_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.curr), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_is__due) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_clear__timer.slice<0>().val() ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<0>().val()))).val());
	}
	// \src: top.v:578.3-579.28
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4543
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__losses.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6996__data.curr;
	}
	// \src: top.v:575.3-576.29
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4544
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__counter.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6990__data.curr;
	}
	// \src: top.v:572.3-573.29
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4545
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__divisor.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6986__data.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4546 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:552$150
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__index.next = (p_rst ? value<4>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6973__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4547 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:550$149
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_kept__valid.next = (p_rst ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6972__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4548 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:548$148
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6973__q.next = (p_rst ? value<4>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6971__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4549 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:546$147
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6972__q.next = (p_rst ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6970__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4550 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:544$146 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:361$79 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:357$77 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$add$top.v:349$73
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6971__q.next = (p_rst ? value<4>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick.curr ? value<4>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6970__q.curr ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6971__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6971__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$procdff$4551 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:542$145 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:359$78 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$ternary$top.v:353$75 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$and$top.v:355$76 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\timer_inst.$eq$top.v:351$74
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6970__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick.curr ? value<1>{0x1u} : (and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6971__q.curr, value<4>{0xfu}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6970__q.curr) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_n6970__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$procdff$4527 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$ternary$top.v:857$303 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$ternary$top.v:853$301
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6645__o ? value<1>{0x1u} : value<1>{0u}));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$procdff$4528 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$ternary$top.v:859$304 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$ternary$top.v:855$302 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.\tick_inst.$sub$top.v:849$299
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6659__q.next = (p_rst ? value<6>{0x31u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6645__o ? value<6>{0x31u} : sub_uu<6>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_tick__inst_2e_n6659__q.curr, value<1>{0x1u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4499 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4659$1594
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3695__q.next = (p_rst ? value<16>{0xffffu} : p_trigger);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4498 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4661$1595
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3696__q.next = (p_rst ? value<16>{0xffffu} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3695__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4497 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4663$1596
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3697__q.next = (p_rst ? value<16>{0xffffu} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3696__q.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4496 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5820$1985 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4060 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5396$1861 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5388$1857 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4076 $auto$opt_reduce.cc:131:opt_pmux$4670 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5414$1870 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5412$1869 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5410$1868 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5430$1878 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5426$1876 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5458$1892 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5454$1890 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5452$1889 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5450$1888 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5470$1898 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5644$1969
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4914__q.next = (p_rst ? value<4>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3941__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3858__o ? value<4>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3843__o ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4073__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4074__CMP).val()) ? value<4>{0x9u} : value<4>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4914__q.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3942__CMP ? value<4>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP ? (and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3362__q.curr.slice<68,66>().val(), value<2>{0x3u}), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4225__o) ? value<4>{0x8u} : value<4>{0x3u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP ? value<4>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP ? value<4>{0x5u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4207__o ? value<3>{0x3u}.concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room.curr ? value<1>{0u} : value<1>{0x1u})).val() : value<4>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3497__o ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3562__o ? value<4>{0x7u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4592__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr.slice<13,6>().val()) ? value<4>{0x7u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4914__q.curr)) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4914__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4225__o ? value<4>{0x9u} : value<4>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out ? value<4>{0x9u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4914__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP ? value<4>{0u} : value<4>{0u})))))))))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4495 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5822$1986 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4048 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5398$1862 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5279$1818 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5390$1858
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4915__q.next = (p_rst ? value<2>{0x2u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4667 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4915__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3941__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3858__o ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4926__q.curr ? value<1>{0u} : value<1>{0x1u})).val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3843__o ? value<2>{0x2u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4915__q.curr)) : value<2>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4494 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5824$1987 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4036 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5400$1863 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5392$1859
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.next = (p_rst ? value<4>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4667 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3941__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3858__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.curr : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3843__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().val() : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4916__q.curr)) : value<4>{0u})));
	}
	// \src: top.v:5851.3-5852.30
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4493
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4944__data.curr;
	}
	// \src: top.v:5854.3-5855.27
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4492
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4948__data.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4491 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5826$1988 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4024 $auto$opt_reduce.cc:131:opt_pmux$4664 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5646$1970 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5640$1967 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5638$1966 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5402$1864 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5394$1860 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4072 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5369$1853 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:5367$1852 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5364$1851 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5362$1850 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5359$1849 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5356$1848 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5354$1847 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5351$1846 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5349$1845 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5346$1844 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5344$1843 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5341$1842 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5339$1841 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5336$1840 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5334$1839 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5331$1838 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5329$1837 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5326$1836 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5324$1835 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5321$1834 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5319$1833 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5316$1832 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5314$1831 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5311$1830 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5309$1829 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5306$1828 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5304$1827 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5301$1826 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5299$1825 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5296$1824 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5294$1823 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5291$1822 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5289$1821 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5287$1820
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.next = (p_rst ? value<16>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4364__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr : or_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4633__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4640__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4646__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4652__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4658__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4664__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4670__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4676__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4682__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4688__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4694__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4700__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4706__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4712__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4718__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4723__o).val())) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3942__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3941__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3858__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3843__o ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4073__CMP ? value<16>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_4074__CMP ? and_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr, not_u<16>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().val(), value<4>{0xfu}) ? value<1>{0x1u} : value<1>{0u}).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().val(), value<4>{0xeu}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().val(), value<4>{0xdu}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().val(), value<4>{0xcu}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().val(), value<4>{0xbu}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().val(), value<4>{0xau}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().val(), value<4>{0x8u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().val(), value<3>{0x7u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().val(), value<3>{0x6u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().val(), value<3>{0x5u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().val(), value<3>{0x4u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().val(), value<2>{0x3u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().val(), value<2>{0x2u}) ? value<1>{0x1u} : value<1>{0u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().val(), value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u})).concat((logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,45>().val()) ? value<1>{0x1u} : value<1>{0u})).val())) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr)) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr)) : value<16>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4490 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5828$1989 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4012 $auto$opt_reduce.cc:131:opt_pmux$4662 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5642$1968 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5648$1971 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5556$1933
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.next = (p_rst ? value<16>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4364__o, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_carry__out) ? or_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4633__o.concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4640__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4646__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4652__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4658__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4664__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4670__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4676__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4682__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4688__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4694__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4700__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4706__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4712__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4718__o).concat(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4723__o).val()) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3941__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3942__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr : value<16>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4489 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4657$1593 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4655$1592 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4653$1591 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:5042$1736 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5037$1734 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5032$1732 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5027$1730 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5022$1728 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5017$1726 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5012$1724 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5007$1722 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5002$1720 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4997$1718 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4992$1716 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4987$1714 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4982$1712 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4977$1710 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4972$1708 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4967$1706 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4962$1704 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$or$top.v:4651$1590 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4649$1589 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:4647$1588 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$not$top.v:4645$1587
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__trigger.next = (p_rst ? value<16>{0u} : and_uu<16>(or_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__trigger.curr, and_uu<16>(and_uu<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3696__q.curr, not_u<16>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3697__q.curr)), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4921__q.curr)), not_u<16>(or_uu<16>((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3867__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u}).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3873__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3878__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3883__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3888__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3893__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3898__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3903__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3908__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3913__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3918__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3923__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3928__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3933__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3938__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3943__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3950__o : value<1>{0u})).val(), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3946__o))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4488 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4838$1650 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4832$1647 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4822$1644 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4812$1641 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4802$1638 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4792$1635 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4782$1632 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4772$1629 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4762$1626 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4752$1623 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4742$1620 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4732$1617 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4722$1614 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4712$1611 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4702$1608 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4692$1605 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4682$1602
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4924__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<0>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<1>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<2>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<3>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<4>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<5>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<6>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<7>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<8>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<9>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<10>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<11>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<12>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<13>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<14>().val() ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<15>().val() ? value<1>{0x1u} : value<1>{0u})))))))))))))))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4487 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4840$1651 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4834$1648 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4824$1645 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4814$1642 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4804$1639 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4794$1636 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4784$1633 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4774$1630 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4764$1627 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4754$1624 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4744$1621 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4734$1618 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4724$1615 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4714$1612 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4704$1609 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4694$1606 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4684$1603
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4925__q.next = (p_rst ? value<4>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<0>().val() ? value<4>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<1>().val() ? value<4>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<2>().val() ? value<4>{0x2u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<3>().val() ? value<4>{0x3u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<4>().val() ? value<4>{0x4u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<5>().val() ? value<4>{0x5u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<6>().val() ? value<4>{0x6u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<7>().val() ? value<4>{0x7u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<8>().val() ? value<4>{0x8u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<9>().val() ? value<4>{0x9u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<10>().val() ? value<4>{0xau} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<11>().val() ? value<4>{0xbu} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<12>().val() ? value<4>{0xcu} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<13>().val() ? value<4>{0xdu} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<14>().val() ? value<4>{0xeu} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<15>().val() ? value<4>{0xfu} : value<4>{0u})))))))))))))))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4486 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4842$1652 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4836$1649 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4826$1646 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4816$1643 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4806$1640 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4796$1637 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4786$1634 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4776$1631 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4766$1628 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4756$1625 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4746$1622 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4736$1619 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4726$1616 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4716$1613 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4706$1610 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4696$1607 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:4686$1604
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4926__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<0>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<0>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<1>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<1>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<2>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<2>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<3>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<3>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<4>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<4>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<5>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<5>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<6>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<6>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<7>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<7>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<8>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<8>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<9>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<9>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<10>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<10>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<11>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<11>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<12>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<12>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<13>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<13>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<14>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<14>().val() : (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n3702__o.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_due__by__timer.curr.slice<15>().val() : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4926__q.curr)))))))))))))))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4485 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5830$1990 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$4000 $auto$opt_reduce.cc:131:opt_pmux$4660
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4927__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP ? value<1>{0x1u} : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3941__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3942__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4927__q.curr : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4484 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5832$1991 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3988 $auto$opt_reduce.cc:131:opt_pmux$4658
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost__kept.next = (p_rst ? value<8>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3942__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost.curr : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3941__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost__kept.curr : value<8>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4483 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5119$1752 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5115$1750
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.next = (p_rst ? value<32>{0u} : add_uu<32>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4929__q.curr, value<1>{0x1u}));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4482 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5113$1749 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$eq$top.v:5109$1747 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5111$1748
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4930__q.next = (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4915__q.curr) ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<7,0>().val(), p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_lost__kept.curr) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_group__state.curr.slice<7,0>().val());
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4481 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5834$1992 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3976 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5438$1882
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.next = (p_rst ? value<8>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_grant__sample ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4248__o : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4651 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_asked.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3941__CMP ? value<8>{0u} : value<8>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4480 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5836$1993 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3964 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5460$1893
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4932__q.next = (p_rst ? value<8>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3497__o ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4592__o : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4932__q.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4651 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4932__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3941__CMP ? value<8>{0u} : value<8>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4479 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5838$1994 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3952 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5444$1885 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5462$1894 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ne$top.v:5442$1884
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP ? (and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3652__q.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__word.curr), p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3497__o) ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_4651 ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_changed.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3941__CMP ? value<1>{0u} : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4478 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5840$1995 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3940 $auto$opt_reduce.cc:131:opt_pmux$4648 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5456$1891 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$and$top.v:5464$1895 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5432$1879 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5428$1877
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3947__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3562__o, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3497__o) ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3946__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4207__o ? (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room.curr ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr : value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3942__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3943__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3944__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3945__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3948__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3949__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3950__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_failed.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3941__CMP ? value<1>{0u} : value<1>{0u})))));
	}
	// \src: top.v:5899.3-5900.26
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4477
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__word.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__read.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4476 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5101$1744 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5099$1743 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$add$top.v:5093$1742
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4938__q.next = (p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr.slice<3>().val() ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr.slice<13,6>().val(), value<2>{0x2u}) : add_uu<9>(p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4918__q.curr.slice<13,6>().val(), value<1>{0x1u}));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4475 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5107$1746 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ge$top.v:5105$1745
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_enough__room.next = (ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__groups__ring__room.curr, p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4938__q.curr) ? value<1>{0x1u} : value<1>{0u});
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4474 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5089$1741 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$ternary$top.v:5087$1740 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$lt$top.v:5078$1739 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3878 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3879_CMP0 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3880_CMP0 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3881_CMP0 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3882_CMP0 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3883 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3888 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3893 $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procmux$3898
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_group__is__set.next = (p_rst ? value<1>{0u} : (lt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<52,45>().val(), value<5>{0x10u}) ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,47>().val(), value<2>{0x3u}) ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3884__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3885__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<14>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3886__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<13>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3887__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<12>().val() : value<1>{0u})))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,47>().val(), value<2>{0x2u}) ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3884__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<11>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3885__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<10>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3886__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3887__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<8>().val() : value<1>{0u})))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,47>().val(), value<1>{0x1u}) ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3884__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<7>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3885__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<6>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3886__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3887__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<4>().val() : value<1>{0u})))) : (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2144__q.curr.slice<48,47>().val()) ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3884__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3885__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<2>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3886__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<1>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_procmux_24_3887__CMP ? p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_is__set.curr.slice<0>().val() : value<1>{0u})))) : value<1>{0u})))) : value<1>{0u}));
	}
	// \src: top.v:5911.3-5912.29
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4473
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_sample__address.next = p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_address__read.curr;
	}
	// \src: top.v:5933.3-5935.45
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4472
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4944__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4944__data_5b_13_3a_0_5d_;
	}
	// \src: top.v:5961.3-5963.42
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4468
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_n4948__data.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4948__data_5b_9_3a_0_5d_;
	}
	// \src: top.v:5971.3-5973.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4464
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_address__read.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4951__data_5b_7_3a_0_5d_;
	}
	// \src: top.v:5981.3-5983.35
	// cell $flatten\unity_link_inst.\core_inst.\with_groups_subscription_manager_inst.$procdff$4460
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_last__read.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__groups__subscription__manager__inst_2e__24_0_5c_n4954__data_5b_31_3a_0_5d_;
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$4515 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$4334
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6595__data.next = (p_unity__link__inst_2e_core__inst_2e_n198__o ? i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_1142_24_374__DATA : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n6595__data.curr);
	}
	// connection
	p_out__data = p_unity__link__inst_2e_core__inst_2e_tx__entry.slice<7,0>().val();
	// connection
	p_wb__sel = value<4>{0xfu};
	return converged;
}

} // namespace cxxrtl_design

