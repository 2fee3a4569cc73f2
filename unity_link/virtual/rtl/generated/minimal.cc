// ad87092bdeaf2c90 names what this was made from: unity_link_fifo in its configuration 'minimal', by GHDL and Yosys 0.70.0.
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
// \src: top.v:9689.1-9782.10
struct p_unity__link__fifo : public module {
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4747_q
	// \src: top.v:1296.14-1296.21
	wire<93> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q;
	// \hdlname: unity_link_inst core_inst request_executor_inst memory_kept
	// \src: top.v:3337.14-3337.25
	wire<8> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2136_q
	// \src: top.v:6314.15-6314.22
	wire<118> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3499_o
	// \src: top.v:2774.8-2774.15
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3499__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3634_q
	// \src: top.v:2844.13-2844.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3634__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3632_q
	// \src: top.v:2842.14-2842.21
	wire<11> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3632__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3631_q
	// \src: top.v:2841.7-2841.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3631__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3629_q
	// \src: top.v:2839.7-2839.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3629__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3626_q
	// \src: top.v:2836.13-2836.20
	wire<2> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3626__q;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n920_q
	// \src: top.v:7954.14-7954.20
	wire<54> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3344_q
	// \src: top.v:4022.14-4022.21
	wire<75> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q;
	// \hdlname: unity_link_inst core_inst request_executor_inst ring_room
	// \src: top.v:3294.17-3294.26
	wire<2> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5165_data
	// \src: top.v:66.13-66.23
	wire<10> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5165__data;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5164_q
	// \src: top.v:65.7-65.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5164__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5157_q
	// \src: top.v:60.13-60.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5157__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5156_q
	// \src: top.v:59.13-59.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5156__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst bypass
	// \src: top.v:19.14-19.20
	wire<10> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst count
	// \src: top.v:8599.14-8599.19
	wire<9> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst bypass
	// \src: top.v:8605.14-8605.20
	wire<9> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n328_q
	// \src: top.v:8645.13-8645.19
	wire<8> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n328__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n329_q
	// \src: top.v:8646.13-8646.19
	wire<8> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n329__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n336_q
	// \src: top.v:8651.7-8651.13
	wire<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n336__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n337_data
	// \src: top.v:8652.13-8652.22
	wire<9> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n337__data;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst count
	// \src: top.v:13.14-13.19
	wire<9> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count;
	// \hdlname: unity_link_inst core_inst frame_writer_inst response_word
	// \src: top.v:793.17-793.30
	wire<8> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word;
	// \hdlname: unity_link_inst core_inst sent_ready
	// \src: top.v:8973.8-8973.18
	wire<1> p_unity__link__inst_2e_core__inst_2e_sent__ready;
	// \hdlname: unity_link_inst core_inst access_failure
	// \src: top.v:8946.14-8946.28
	wire<4> p_unity__link__inst_2e_core__inst_2e_access__failure;
	// \hdlname: unity_link_inst core_inst response_ring_inst committed
	// \src: top.v:3183.14-3183.23
	wire<2> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed;
	// \hdlname: unity_link_inst core_inst memory_word
	// \src: top.v:8928.14-8928.25
	wire<8> p_unity__link__inst_2e_core__inst_2e_memory__word;
	// \hdlname: unity_link_inst core_inst response_ring_inst n3419_q
	// \src: top.v:3202.13-3202.20
	wire<2> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3419__q;
	// \hdlname: unity_link_inst core_inst response_ring_inst n3421_q
	// \src: top.v:3204.13-3204.20
	wire<2> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3421__q;
	// \hdlname: unity_link_inst core_inst character_valid
	// \src: top.v:8901.8-8901.23
	wire<1> p_unity__link__inst_2e_core__inst_2e_character__valid;
	// \hdlname: unity_link_inst core_inst character_in
	// \src: top.v:8900.14-8900.26
	wire<9> p_unity__link__inst_2e_core__inst_2e_character__in;
	// \hdlname: unity_link_inst core_inst fifo_out_valid
	// \src: top.v:8898.8-8898.22
	wire<1> p_unity__link__inst_2e_core__inst_2e_fifo__out__valid;
	// \hdlname: unity_link_inst core_inst bus_master_inst for_sample
	// \src: top.v:2741.8-2741.18
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n5061_q
	// \src: top.v:380.14-380.21
	wire<26> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q;
	// \src: top.v:9710.17-9710.25
	/*output*/ wire<8> p_wb__dat__o;
	// \src: top.v:9709.17-9709.23
	/*output*/ wire<8> p_wb__adr;
	// \src: top.v:9708.11-9708.17
	/*output*/ value<1> p_wb__sel;
	// \src: top.v:9707.11-9707.16
	/*output*/ wire<1> p_wb__we;
	// \src: top.v:9706.11-9706.17
	/*output*/ wire<1> p_wb__stb;
	// \src: top.v:9705.11-9705.17
	/*output*/ value<1> p_wb__cyc;
	// \src: top.v:9704.11-9704.20
	/*output*/ value<1> p_out__flush;
	// \src: top.v:9703.11-9703.20
	/*output*/ wire<1> p_out__valid;
	// \src: top.v:9702.17-9702.25
	/*output*/ value<8> p_out__data;
	// \src: top.v:9701.11-9701.19
	/*output*/ wire<1> p_in__ready;
	// \src: top.v:9700.11-9700.19
	/*input*/ value<1> p_wb__stall;
	// \src: top.v:9699.11-9699.17
	/*input*/ value<1> p_wb__err;
	// \src: top.v:9698.11-9698.17
	/*input*/ value<1> p_wb__ack;
	// \src: top.v:9697.17-9697.25
	/*input*/ value<8> p_wb__dat__i;
	// \src: top.v:9696.11-9696.18
	/*input*/ value<1> p_trigger;
	// \src: top.v:9695.11-9695.20
	/*input*/ value<1> p_out__ready;
	// \src: top.v:9694.11-9694.19
	/*input*/ value<1> p_in__valid;
	// \src: top.v:9693.11-9693.18
	/*input*/ value<1> p_in__lost;
	// \src: top.v:9692.17-9692.24
	/*input*/ value<8> p_in__data;
	// \src: top.v:9691.11-9691.14
	/*input*/ value<1> p_rst;
	// \src: top.v:9690.11-9690.14
	/*input*/ value<1> p_clk;
	value<1> prev_p_clk;
	bool posedge_p_clk() const {
		return !prev_p_clk.slice<0>().val() && p_clk.slice<0>().val();
	}
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4748
	// \src: top.v:2433.13-2433.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4748 { 64u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4750
	// \src: top.v:2503.13-2503.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4750 { 64u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4752
	// \src: top.v:2573.13-2573.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4752 { 64u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4754
	// \src: top.v:2643.13-2643.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4754 { 64u };
	// \hdlname: unity_link_inst core_inst response_ring_inst memory
	// \src: top.v:3267.13-3267.19
	memory<8> memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory { 2u };
	// \hdlname: unity_link_inst core_inst rx_fifo_inst memory
	// \no_rw_check: 1
	// \src: top.v:8775.36-8775.42
	memory<9> memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory { 256u };
	// \hdlname: unity_link_inst core_inst tx_fifo_inst memory
	// \no_rw_check: 1
	// \src: top.v:189.36-189.42
	memory<10> memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory { 256u };
	// \hdlname: unity_link_inst core_inst request_memory_inst memory
	// \src: top.v:5689.13-5689.19
	memory<8> memory_p_unity__link__inst_2e_core__inst_2e_request__memory__inst_2e_memory { 2u };

	p_unity__link__fifo(interior) {}
	p_unity__link__fifo() {
		reset();
	};

	void reset() override;

	bool eval(performer *performer = nullptr) override;

	template<class ObserverT>
	bool commit(ObserverT &observer) {
		bool changed = false;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3499__o.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3634__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3632__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3631__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3629__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3626__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5165__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5164__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5157__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5156__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n328__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n329__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n336__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n337__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_sent__ready.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_access__failure.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_memory__word.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3419__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3421__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_character__valid.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_character__in.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.commit(observer)) changed = true;
		if (p_wb__dat__o.commit(observer)) changed = true;
		if (p_wb__adr.commit(observer)) changed = true;
		if (p_wb__we.commit(observer)) changed = true;
		if (p_wb__stb.commit(observer)) changed = true;
		if (p_out__valid.commit(observer)) changed = true;
		if (p_in__ready.commit(observer)) changed = true;
		prev_p_clk = p_clk;
		if (memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory.commit(observer)) changed = true;
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
		value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0xau},
		value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x6u}, value<4>{0x9u},
		value<4>{0x8u}, value<4>{0x9u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x1u}, value<4>{0x0u}, value<4>{0x7u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x2u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x8u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_1), std::end(mem_init_1), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4748.data[0]);
	static const value<4> mem_init_2[64] {
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0xau},
		value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x6u}, value<4>{0x9u},
		value<4>{0x8u}, value<4>{0x9u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x1u}, value<4>{0x0u}, value<4>{0x7u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x2u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x8u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_2), std::end(mem_init_2), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4750.data[0]);
	static const value<4> mem_init_3[64] {
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0xau},
		value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x6u}, value<4>{0x9u},
		value<4>{0x8u}, value<4>{0x9u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x1u}, value<4>{0x0u}, value<4>{0x7u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x2u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x8u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_3), std::end(mem_init_3), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4752.data[0]);
	static const value<4> mem_init_4[64] {
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0xau},
		value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x6u}, value<4>{0x9u},
		value<4>{0x8u}, value<4>{0x9u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x1u}, value<4>{0x0u}, value<4>{0x7u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x2u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x8u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_4), std::end(mem_init_4), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4754.data[0]);
}

bool p_unity__link__fifo::eval(performer *performer) {
	bool converged = true;
	bool posedge_p_clk = this->posedge_p_clk();
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2724__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3950_o
	// \src: top.v:955.8-955.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3950__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4880_o
	// \src: top.v:274.14-274.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4880__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2710__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2692__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2691__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1786_o
	// \src: top.v:6134.8-6134.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1786__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4873_o
	// \src: top.v:269.14-269.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4873__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1789_o
	// \src: top.v:6136.8-6136.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1789__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2687__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1795_o
	// \src: top.v:6140.8-6140.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1795__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1796_o
	// \src: top.v:6141.8-6141.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1796__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4866_o
	// \src: top.v:264.14-264.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4866__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1799_o
	// \src: top.v:6143.8-6143.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1799__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4859_o
	// \src: top.v:259.14-259.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4859__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4521_o
	// \src: top.v:1173.13-1173.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4521__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4918_o
	// \src: top.v:294.14-294.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4918__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4904_o
	// \src: top.v:292.8-292.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4904__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4899_o
	// \src: top.v:288.15-288.22
	value<13> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4899__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1396_o
	// \src: top.v:5925.14-5925.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4852_o
	// \src: top.v:254.14-254.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4852__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2389__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2406__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2413__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2419__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2424__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2428__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4845_o
	// \src: top.v:249.14-249.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4845__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2431__CMP;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3339;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1849_o
	// \src: top.v:6171.8-6171.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1849__o;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3343;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3349;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2443__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2444__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2445__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2446__CMP;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3355;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3357;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2455__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2456__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2457__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2458__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1401_o
	// \src: top.v:5928.8-5928.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2467__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2652__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2468__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2469__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2470__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4586_o
	// \src: top.v:1206.8-1206.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4586__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2479__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2480__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4838_o
	// \src: top.v:244.14-244.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4838__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2487__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2488__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2489__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2490__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2491__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2492__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1887_o
	// \src: top.v:6185.8-6185.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1887__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1893_o
	// \src: top.v:6189.8-6189.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1893__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4625_o
	// \src: top.v:1223.13-1223.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4625__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1149_o
	// \src: top.v:5822.8-5822.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1149__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1899_o
	// \src: top.v:6193.8-6193.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1899__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1405_o
	// \src: top.v:5931.8-5931.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst advance
	// \src: top.v:7637.8-7637.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_advance;
	// \hdlname: unity_link_inst core_inst request_executor_inst is_queue
	// \src: top.v:3331.8-3331.16
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n390_o
	// \src: top.v:7655.8-7655.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n390__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1411_o
	// \src: top.v:5935.8-5935.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1411__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1412_o
	// \src: top.v:5936.8-5936.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1940_o
	// \src: top.v:6215.8-6215.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1946_o
	// \src: top.v:6216.8-6216.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1946__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1954_o
	// \src: top.v:6218.8-6218.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1954__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n439_o
	// \src: top.v:7670.14-7670.20
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n439__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1062_o
	// \src: top.v:5786.8-5786.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1062__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst left
	// \src: top.v:5735.14-5735.18
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1416_o
	// \src: top.v:5939.8-5939.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst field
	// \src: top.v:5734.14-5734.19
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4954_o
	// \src: top.v:319.14-319.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4954__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst digit
	// \src: top.v:5733.8-5733.13
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1420_o
	// \src: top.v:5942.8-5942.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1965_o
	// \src: top.v:6227.8-6227.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1965__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4961_o
	// \src: top.v:324.14-324.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4961__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst letter
	// \src: top.v:5732.8-5732.14
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1152_o
	// \src: top.v:5825.8-5825.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1152__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1424_o
	// \src: top.v:5945.8-5945.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1059_o
	// \src: top.v:5784.14-5784.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3864_o
	// \src: top.v:926.8-926.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3864__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n498_o
	// \src: top.v:7712.14-7712.20
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n498__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n499_o
	// \src: top.v:7713.8-7713.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1054_o
	// \src: top.v:5783.14-5783.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4749_data
	// \src: top.v:1297.14-1297.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4749__data;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4751_data
	// \src: top.v:1298.14-1298.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4751__data;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4753_data
	// \src: top.v:1299.14-1299.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4753__data;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4755_data
	// \src: top.v:1300.14-1300.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4755__data;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4968_o
	// \src: top.v:329.14-329.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4968__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1998_o
	// \src: top.v:6245.8-6245.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1998__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n530_o
	// \src: top.v:7742.8-7742.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n530__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n539_o
	// \src: top.v:7744.8-7744.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n539__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n540_o
	// \src: top.v:7745.8-7745.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n540__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3067__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3066__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n554_o
	// \src: top.v:7754.8-7754.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n554__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3065__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1049_o
	// \src: top.v:5780.8-5780.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4004_o
	// \src: top.v:970.8-970.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4004__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2508_o
	// \src: top.v:3490.8-3490.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2508__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n607_o
	// \src: top.v:7765.8-7765.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n607__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1435_o
	// \src: top.v:5954.8-5954.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1437_o
	// \src: top.v:5955.8-5955.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1437__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n627_o
	// \src: top.v:7774.8-7774.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n627__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2664_o
	// \src: top.v:3570.13-3570.20
	value<3> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2664__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2528_o
	// \src: top.v:3494.8-3494.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2528__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1438_o
	// \src: top.v:5956.8-5956.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2670_o
	// \src: top.v:3576.13-3576.20
	value<2> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2670__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n673_o
	// \src: top.v:7793.8-7793.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n673__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n693_o
	// \src: top.v:7802.8-7802.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n693__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4947_o
	// \src: top.v:314.14-314.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4947__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2683_o
	// \src: top.v:3589.8-3589.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2683__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2685_o
	// \src: top.v:3591.14-3591.21
	value<3> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2685__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2686_o
	// \src: top.v:3592.14-3592.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2686__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2690_o
	// \src: top.v:3595.14-3595.21
	value<8> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2690__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2057_o
	// \src: top.v:6277.14-6277.21
	value<10> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2057__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4940_o
	// \src: top.v:309.14-309.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4940__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n759_o
	// \src: top.v:7841.15-7841.21
	value<22> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n759__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n762_o
	// \src: top.v:7844.14-7844.20
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n762__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2554_o
	// \src: top.v:3507.8-3507.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2554__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n770_o
	// \src: top.v:7849.8-7849.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n770__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3860_o
	// \src: top.v:925.8-925.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3860__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3845_o
	// \src: top.v:920.14-920.21
	value<2> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3845__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2077_o
	// \src: top.v:6297.16-6297.23
	value<118> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2077__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1026_o
	// \src: top.v:5772.8-5772.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2079_o
	// \src: top.v:6299.8-6299.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2079__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2936__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2935__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4016_o
	// \src: top.v:974.8-974.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4016__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1014_o
	// \src: top.v:5767.8-5767.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1014__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2934__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1470_o
	// \src: top.v:5982.15-5982.22
	value<11> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1470__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1474_o
	// \src: top.v:5984.8-5984.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1474__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3482_o
	// \src: top.v:2766.8-2766.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3482__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3838_o
	// \src: top.v:913.15-913.22
	value<22> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3838__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n864_o
	// \src: top.v:7906.15-7906.21
	value<26> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n864__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n867_o
	// \src: top.v:7909.14-7909.20
	value<9> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n867__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n870_o
	// \src: top.v:7911.8-7911.14
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n870__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1161_o
	// \src: top.v:5834.8-5834.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1161__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3544_o
	// \src: top.v:2801.8-2801.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3544__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3542_o
	// \src: top.v:2800.8-2800.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3542__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4817_o
	// \src: top.v:237.13-237.20
	value<7> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4817__o_5b_6_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1244_o
	// \src: top.v:5876.8-5876.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1244__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4830_o
	// \src: top.v:239.14-239.21
	value<8> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4830__o;
	// \src: top.v:193.3-195.35
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_195_24_1__EN_5b_9_3a_0_5d__24_52_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4813_o
	// \src: top.v:235.8-235.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4813__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1247_o
	// \src: top.v:5877.8-5877.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1247__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1250_o
	// \src: top.v:5878.8-5878.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1250__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4767_o
	// \src: top.v:220.8-220.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4767__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1516_o
	// \src: top.v:5999.8-5999.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1516__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst advance
	// \src: top.v:215.8-215.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_advance;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1518_o
	// \src: top.v:6000.8-6000.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1518__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1519_o
	// \src: top.v:6001.8-6001.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1522_o
	// \src: top.v:6002.8-6002.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1522__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2529__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3754_o
	// \src: top.v:873.8-873.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3754__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2528__CMP;
	// \src: top.v:192.21-192.27
	value<10> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_192_24_48__DATA;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3741_o
	// \src: top.v:868.8-868.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3741__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2527__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3737_o
	// \src: top.v:865.8-865.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3737__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2526__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3266_o
	// \src: top.v:3974.8-3974.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3266__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2524__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3731_o
	// \src: top.v:860.8-860.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3731__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3261_o
	// \src: top.v:3971.8-3971.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3261__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4034_o
	// \src: top.v:978.8-978.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4034__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3715_o
	// \src: top.v:853.8-853.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3715__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3712_o
	// \src: top.v:851.8-851.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3240_o
	// \src: top.v:3957.8-3957.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3240__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3235_o
	// \src: top.v:3955.8-3955.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3235__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst failed
	// \src: top.v:3336.8-3336.14
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4043_o
	// \src: top.v:980.8-980.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4043__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3230_o
	// \src: top.v:3952.8-3952.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3230__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4052_o
	// \src: top.v:982.8-982.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4052__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4061_o
	// \src: top.v:984.8-984.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4061__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1253_o
	// \src: top.v:5879.8-5879.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4074_o
	// \src: top.v:988.14-988.21
	value<5> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4074__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4076_o
	// \src: top.v:989.8-989.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4076__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1256_o
	// \src: top.v:5880.8-5880.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4083_o
	// \src: top.v:991.8-991.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4083__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5117_o
	// \src: top.v:42.8-42.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5117__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5109_o
	// \src: top.v:37.8-37.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5109__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5102_o
	// \src: top.v:32.8-32.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5102__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5099_o
	// \src: top.v:29.8-29.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5099__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1548_o
	// \src: top.v:6010.8-6010.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4088_o
	// \src: top.v:993.8-993.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4088__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1260_o
	// \src: top.v:5881.8-5881.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1260__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3889_o
	// \src: top.v:934.8-934.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3889__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2866__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4109_o
	// \src: top.v:1000.8-1000.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4109__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5069_o
	// \src: top.v:22.8-22.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5069__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5068_o
	// \src: top.v:21.8-21.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5068__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4113_o
	// \src: top.v:1001.14-1001.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4113__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4115_o
	// \src: top.v:1003.14-1003.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4115__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3523_o
	// \src: top.v:2790.8-2790.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3654_o
	// \src: top.v:817.8-817.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3654__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4933_o
	// \src: top.v:304.14-304.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4933__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4117_o
	// \src: top.v:1005.8-1005.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4117__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3160_o
	// \src: top.v:3900.14-3900.21
	value<8> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3160__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n240_o
	// \src: top.v:8607.8-8607.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n240__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n241_o
	// \src: top.v:8608.8-8608.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n241__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n271_o
	// \src: top.v:8615.8-8615.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n271__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n274_o
	// \src: top.v:8618.8-8618.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n274__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n281_o
	// \src: top.v:8623.8-8623.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n281__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n289_o
	// \src: top.v:8628.8-8628.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n289__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3155_o
	// \src: top.v:3896.8-3896.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3155__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3151_o
	// \src: top.v:3895.8-3895.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3151__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst load_word
	// \src: top.v:810.8-810.17
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3140_o
	// \src: top.v:3888.14-3888.21
	value<5> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3140__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst advance
	// \src: top.v:807.8-807.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3138_o
	// \src: top.v:3886.14-3886.21
	value<5> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3138__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3137_o
	// \src: top.v:3885.15-3885.22
	value<31> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3137__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3135_o
	// \src: top.v:3883.15-3883.22
	value<14> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3135__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2867__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4124_o
	// \src: top.v:1012.14-1012.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4124__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4125_o
	// \src: top.v:1013.14-1013.21
	value<6> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4125__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4126_o
	// \src: top.v:1014.8-1014.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4126__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1576_o
	// \src: top.v:6019.8-6019.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1576__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst last_word
	// \src: top.v:3334.8-3334.17
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4132_o
	// \src: top.v:1019.8-1019.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4132__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3892_o
	// \src: top.v:936.8-936.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3892__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3108_o
	// \src: top.v:3856.15-3856.22
	value<14> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3108__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1593_o
	// \src: top.v:6021.13-6021.20
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1593__o;
	// \src: top.v:5690.3-5692.40
	value<8> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2158__data_5b_7_3a_0_5d_;
	// \hdlname: unity_link_inst bus_done
	// \src: top.v:9538.8-9538.16
	value<1> p_unity__link__inst_2e_bus__done;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3893_o
	// \src: top.v:937.8-937.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3893__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1262_o
	// \src: top.v:5882.8-5882.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1262__o;
	// \src: top.v:8778.20-8778.26
	value<9> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_8778_24_2315__DATA;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1282_o
	// \src: top.v:5886.8-5886.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1282__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1285_o
	// \src: top.v:5887.8-5887.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1285__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3062_o
	// \src: top.v:3813.14-3813.21
	value<11> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3062__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2307_o
	// \src: top.v:3390.8-3390.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2307__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2300_o
	// \src: top.v:3389.8-3389.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2300__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n994_o
	// \src: top.v:5758.8-5758.14
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n994__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2296_o
	// \src: top.v:3387.8-3387.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2296__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3052_o
	// \src: top.v:3805.8-3805.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3052__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3904_o
	// \src: top.v:940.8-940.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3904__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3043_o
	// \src: top.v:3802.8-3802.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3043__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3460_o
	// \src: top.v:2760.8-2760.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3460__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1635_o
	// \src: top.v:6040.14-6040.21
	value<9> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1635__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3032_o
	// \src: top.v:3793.15-3793.22
	value<14> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3032__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1301_o
	// \src: top.v:5892.8-5892.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1301__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2263_o
	// \src: top.v:3368.8-3368.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2263__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2353_o
	// \src: top.v:3409.8-3409.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2353__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3907_o
	// \src: top.v:942.8-942.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3907__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3009_o
	// \src: top.v:3771.15-3771.22
	value<14> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3009__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1307_o
	// \src: top.v:5894.8-5894.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3119__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3118__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3117__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3116__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3115__CMP;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2210_o
	// \src: top.v:3348.8-3348.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2210__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2198_o
	// \src: top.v:3344.8-3344.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2198__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2195_o
	// \src: top.v:3342.8-3342.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2195__o;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3317;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1331_o
	// \src: top.v:5900.8-5900.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1331__o;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3319;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3913_o
	// \src: top.v:946.8-946.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3913__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3914_o
	// \src: top.v:947.8-947.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3914__o;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3331;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4294_o
	// \src: top.v:1074.8-1074.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4294__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1337_o
	// \src: top.v:5902.8-5902.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1337__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1340_o
	// \src: top.v:5903.8-5903.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1340__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1671_o
	// \src: top.v:6074.15-6074.22
	value<93> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o;
	// \hdlname: unity_link_inst core_inst answer_has_id
	// \src: top.v:8958.8-8958.21
	value<1> p_unity__link__inst_2e_core__inst_2e_answer__has__id;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1343_o
	// \src: top.v:5904.8-5904.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1343__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1674_o
	// \src: top.v:6077.8-6077.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o;
	// \hdlname: unity_link_inst core_inst answer_taken
	// \src: top.v:8953.8-8953.20
	value<1> p_unity__link__inst_2e_core__inst_2e_answer__taken;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4322_o
	// \src: top.v:1081.8-1081.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4322__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4325_o
	// \src: top.v:1084.13-1084.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4325__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2379_o
	// \src: top.v:3424.8-3424.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2379__o;
	// \hdlname: unity_link_inst core_inst access_done
	// \src: top.v:8942.8-8942.19
	value<1> p_unity__link__inst_2e_core__inst_2e_access__done;
	// \hdlname: unity_link_inst core_inst access_granted
	// \src: top.v:8941.8-8941.22
	value<1> p_unity__link__inst_2e_core__inst_2e_access__granted;
	// \hdlname: unity_link_inst core_inst access_exclusive
	// \src: top.v:8938.8-8938.24
	value<1> p_unity__link__inst_2e_core__inst_2e_access__exclusive;
	// \hdlname: unity_link_inst core_inst response_ring_inst n3386_o
	// \src: top.v:3189.14-3189.21
	value<2> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3386__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1683_o
	// \src: top.v:6083.8-6083.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1683__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1690_o
	// \src: top.v:6089.8-6089.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1690__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3923_o
	// \src: top.v:949.8-949.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3923__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1693_o
	// \src: top.v:6091.8-6091.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1693__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1694_o
	// \src: top.v:6092.8-6092.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1694__o;
	// \hdlname: unity_link_inst core_inst fifo_out_ready
	// \src: top.v:8899.8-8899.22
	value<1> p_unity__link__inst_2e_core__inst_2e_fifo__out__ready;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1695_o
	// \src: top.v:6093.8-6093.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1695__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1359_o
	// \src: top.v:5908.8-5908.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1359__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4365_o
	// \src: top.v:1105.14-1105.21
	value<6> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4365__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3835_o
	// \src: top.v:910.14-910.21
	value<9> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3835__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3932_o
	// \src: top.v:951.8-951.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3932__o;
	// \src: top.v:3268.3-3270.37
	value<8> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3426__data_5b_7_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n489_o
	// \src: top.v:7705.14-7705.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n489__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n475_o
	// \src: top.v:7695.14-7695.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n475__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n482_o
	// \src: top.v:7700.14-7700.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n482__o_5b_2_3a_0_5d_;
	// \src: top.v:8779.3-8781.35
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_8781_24_2268__EN_5b_8_3a_0_5d__24_2319_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n468_o
	// \src: top.v:7690.14-7690.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n468__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n461_o
	// \src: top.v:7685.14-7685.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n461__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3941_o
	// \src: top.v:953.8-953.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3941__o;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n454_o
	// \src: top.v:7680.14-7680.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n454__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_rx_datalink_rx_inst n447_o
	// \src: top.v:7675.14-7675.20
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n447__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n5032_o
	// \src: top.v:362.8-362.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5032__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n5023_o
	// \src: top.v:360.8-360.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5023__o;
	// \src: top.v:5693.3-5695.41
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_5695_24_1764__EN_5b_7_3a_0_5d__24_1770_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n5018_o
	// \src: top.v:359.8-359.15
	value<1> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5018__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2549_o
	// \src: top.v:3503.14-3503.21
	value<2> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2549__o_5b_1_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2525_o
	// \src: top.v:3493.14-3493.21
	value<3> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2525__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2727__CMP;
	// \src: top.v:3271.3-3273.37
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_3273_24_1293__EN_5b_7_3a_0_5d__24_1319_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1752_o
	// \src: top.v:6115.8-6115.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1752__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4428_o
	// \src: top.v:1131.13-1131.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4428__o;
	// \hdlname: unity_link_inst core_inst with_datalink_tx_datalink_tx_inst n4926_o
	// \src: top.v:299.14-299.21
	value<3> p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4926__o_5b_2_3a_0_5d_;
	// \src: top.v:8029.19-8029.34
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$xor$top.v:8029$2136
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n439__o = xor_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<25,18>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<7,0>().val());
	// \src: top.v:673.20-673.36
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:673$119
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4813__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<4,3>().val(), value<1>{0x1u});
	// \src: top.v:4505.20-4505.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4505$1485
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<3,0>().val(), value<4>{0xcu});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8039$2138 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$3237
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n447__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n439__o.slice<7>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n439__o.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n439__o.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$3163 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$3164_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:427$64
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4817__o_5b_6_3a_0_5d_ = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4813__o.concat(logic_not<1>(value<29>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<4,3>()).val())).val(), value<1>{0x1u}) ? value<7>{0x5au} : value<7>{0x30u});
	// \src: top.v:4515.20-4515.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4515$1488
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<3,0>().val(), value<4>{0xfu});
	// \src: top.v:6452.20-6452.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6452$1806
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1062__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<11,8>().val());
	// \src: top.v:549.20-549.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$xor$top.v:549$91
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4918__o = xor_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<12,5>().val(), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<87,80>().val());
	// \src: top.v:441.20-441.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$xor$top.v:441$67
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4830__o = xor_uu<8>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<12,5>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4817__o_5b_6_3a_0_5d_);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6446$1804 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6444$1803 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6442$1802 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:6438$1800
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<3>().val() ? (or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<2>().val()), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o) ? value<4>{0x5u} : value<4>{0xau}) : value<4>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8049$2140 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$3239
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n454__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n439__o.slice<6>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n447__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n447__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6448$1805 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6426$1796
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<5>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o) ? value<4>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o);
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:559$93 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3285
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4926__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4918__o.slice<7>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4918__o.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4918__o.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:451$69 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3269
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4838__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4830__o.slice<7>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4830__o.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4830__o.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:6454.20-6454.47
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6454$1807
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1062__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<11,8>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:8215$2180 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:8213$2179 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:8211$2178
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n627__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<15,12>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<15,12>().val(), value<3>{0x6u}));
	// \src: top.v:8197.19-8197.36
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:8197$2173
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n607__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<15,12>().val(), value<2>{0x3u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8059$2142 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$3241
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n461__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n439__o.slice<5>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n454__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n454__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:4424.20-4424.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4424$1449
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1693__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<3,0>().val(), value<3>{0x7u});
	// \src: top.v:4422.20-4422.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4422$1448
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1690__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<3,0>().val(), value<3>{0x4u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6379$1783 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6377$1782 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6375$1781 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ge$top.v:6369$1779 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$le$top.v:6373$1780 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6365$1778 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:6363$1777 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6359$1776 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6355$1775
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter = and_uu<1>(and_uu<1>(and_uu<1>((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1062__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<44>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<45>().val())), (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<5>{0x1au}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<3>{0x7u})) ? value<1>{0x1u} : value<1>{0u}));
	// \src: top.v:7441.20-7441.41
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7441$2069
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<16>().val() ? value<1>{0u} : value<1>{0x1u});
	// \src: top.v:4426.20-4426.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4426$1450
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1694__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1690__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1693__o);
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:569$95 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3287
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4933__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4918__o.slice<6>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4926__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4926__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:461$71 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3271
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4845__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4830__o.slice<6>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4838__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4838__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8069$2144 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$3243
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n468__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n439__o.slice<4>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n461__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n461__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:4090.20-4090.38
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4090$1328
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2210__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<19,16>().val(), value<2>{0x2u});
	// \src: top.v:7501.20-7501.37
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7501$2090
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1998__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1694__o);
	// \src: top.v:7178.20-7178.43
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7178$1981
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1683__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<89,81>().val());
	// \src: top.v:4411.20-4411.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4411$1443
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1522__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<3,0>().val());
	// \src: top.v:4388.20-4388.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4388$1432
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1518__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<3,0>().val(), value<2>{0x2u});
	// \src: top.v:4386.20-4386.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4386$1431
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1516__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<3,0>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:8275$2197 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:8273$2196 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:8271$2195
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n693__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<7,4>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<7,4>().val(), value<3>{0x6u}));
	// \src: top.v:8257.19-8257.36
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:8257$2190
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n673__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<7,4>().val(), value<2>{0x3u});
	// \src: top.v:4078.20-4078.38
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4078$1324
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2195__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<19,16>().val(), value<3>{0x5u});
	// \src: top.v:4413.20-4413.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4413$1444
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1795__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<3,0>().val(), value<2>{0x3u});
	// \src: top.v:7443.20-7443.41
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7443$2070
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1946__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<16>().val() ? value<1>{0u} : value<1>{0u});
	// \src: top.v:6856.20-6856.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6856$1905
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1437__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<4>{0x9u});
	// \src: top.v:6820.20-6820.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6820$1897
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1411__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<4>{0x8u});
	// \src: top.v:4390.20-4390.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4390$1433
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1516__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1518__o);
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:579$97 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3289
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4940__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4918__o.slice<5>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4933__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4933__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:471$73 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3273
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4852__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4830__o.slice<5>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4845__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4845__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8079$2146 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$3245
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n475__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n439__o.slice<3>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n468__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n468__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:4382.20-4382.54
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4382$1429
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2528__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<109>().val() ? value<1>{0u} : value<1>{0x1u});
	// \src: top.v:4082.20-4082.38
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4082$1325
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2198__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<19,16>().val(), value<3>{0x6u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7465$2077 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7461$2076 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7455$2074
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1965__o = or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1062__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<90>().val()), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1683__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<89>().val());
	// \src: top.v:7061.20-7061.37
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7061$1953
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1576__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1411__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1437__o);
	// \src: top.v:6854.20-6854.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6854$1904
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x4u});
	// \src: top.v:6840.20-6840.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6840$1901
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x7u});
	// \src: top.v:6834.20-6834.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6834$1900
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x6u});
	// \src: top.v:6828.20-6828.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6828$1899
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x5u});
	// \src: top.v:6812.20-6812.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6812$1895
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<2>{0x2u});
	// \src: top.v:6806.20-6806.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6806$1894
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<1>{0x1u});
	// \src: top.v:4441.20-4441.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4441$1457
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<3,0>().val(), value<4>{0x8u});
	// \src: top.v:6554.20-6554.28
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:6554$1843
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1161__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<101>().val());
	// \src: top.v:4432.20-4432.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4432$1453
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1789__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<3,0>().val(), value<3>{0x6u});
	// \src: top.v:4430.20-4430.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4430$1452
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1786__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<3,0>().val(), value<3>{0x5u});
	// \src: top.v:7289.20-7289.64
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ge$top.v:7289$2019
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1799__o = ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<48,41>().val(), value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:589$99 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3291
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4947__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4918__o.slice<4>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4940__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4940__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:481$75 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3275
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4859__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4830__o.slice<4>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4852__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4852__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:6536$1836 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6534$1835 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6526$1832 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6524$1831 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6522$1830 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:6520$1829 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:6518$1828 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4138$1347 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:4136$1346
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1152__o = not_u<1>(and_uu<1>((reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<2,0>().val()) ? value<1>{0x1u} : value<1>{0u}), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<47>().val(), and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter), (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u})))));
	// \src: top.v:6530.20-6530.28
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:6530$1833
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1149__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<102>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8089$2148 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$3247
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n482__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n439__o.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n475__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n475__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4498$1483 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4496$1482 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4494$1481 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4492$1480 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4490$1479
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1849__o = or_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<3,0>().val(), value<4>{0x9u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<3,0>().val(), value<4>{0xau})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<3,0>().val(), value<4>{0xbu}));
	// \src: top.v:4434.20-4434.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4434$1454
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1899__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1786__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1789__o);
	// \src: top.v:4415.20-4415.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4415$1445
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1887__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1522__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1795__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4407$1441 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4403$1439 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4397$1436
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2554__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2528__o, logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.curr)), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2528__o);
	// \src: top.v:7447.20-7447.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7447$2072
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1954__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<4>{0xau});
	// \src: top.v:6858.20-6858.37
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6858$1906
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1437__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6822$1898 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6818$1896
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<2>{0x3u}), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1411__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2373 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2374_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2375_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2376_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2377_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2378_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2379_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2380_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7017$1931 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7037$1941 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7033$1939 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7029$1937 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7035$1940 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7031$1938 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7049$1947
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1593__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1576__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<1>{0x1u}) ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o ? value<4>{0xau} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1576__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<2>{0x2u}) ? ((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1522__o ? value<1>{0u} : value<1>{0x1u})) ? value<4>{0x4u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o ? value<4>{0x3u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1522__o ? value<4>{0xau} : value<4>{0u}))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1576__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<3>{0x4u}) ? value<4>{0x4u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1576__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<4>{0x8u}) ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o ? value<4>{0x6u} : value<4>{0xau}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1576__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<5>{0x10u}) ? value<4>{0x7u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1576__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<6>{0x20u}) ? value<4>{0x8u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1576__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<7>{0x40u}) ? value<4>{0x9u} : value<4>{0xau})))))));
	// \src: top.v:5026.20-5026.47
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5026$1636
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3009__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<109>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<13,3>().concat(value<3>{0x7u}).val() : value<3>{0x4u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<24,17>()).concat(value<3>{0x7u}).val());
	// \full_case: 1
	// \src: top.v:4520.19-4520.19|top.v:4520.5-4530.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2850_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2687__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1849__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1899__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1694__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1887__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<8>{0x80u});
	// \full_case: 1
	// \src: top.v:4786.38-4786.38|top.v:4779.5-4789.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2784_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2724__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1849__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1899__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1694__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1887__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:4524.38-4524.38|top.v:4520.5-4530.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2847_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2727__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1849__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1899__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1694__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1887__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:4583.38-4583.38|top.v:4577.5-4587.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2811_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2691__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1849__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1899__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1694__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1887__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:4582.38-4582.38|top.v:4577.5-4587.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2812_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2692__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1849__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1899__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1694__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1887__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<3>{0x4u});
	// \src: top.v:4399.20-4399.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4399$1437
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2549__o_5b_1_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2554__o ? value<2>{0x1u} : value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:4551.38-4551.38|top.v:4550.5-4560.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2830_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2710__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1849__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1899__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1694__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1887__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<7>{0x40u});
	// \src: top.v:4380.20-4380.60
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4380$1428
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2525__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<109>().val() ? value<3>{0x6u} : value<3>{0u});
	// \src: top.v:1405.20-1405.40
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1405$414
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3715__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<77,72>().val());
	// \src: top.v:1419.20-1419.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1419$419
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3731__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<2,0>().val(), value<2>{0x3u});
	// \src: top.v:1563.20-1563.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1563$463
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3904__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<6,3>().val(), value<3>{0x5u});
	// \src: top.v:7236.20-7236.42
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7236$1998
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1752__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<40,33>().val());
	// \full_case: 1
	// \src: top.v:6967.19-6967.19|top.v:6967.5-6976.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2389_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2389__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<7>{0x40u});
	// \src: top.v:6676.20-6676.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6676$1867
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1285__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<4>{0xdu});
	// \src: top.v:6641.20-6641.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6641$1860
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<5>{0x11u});
	// \src: top.v:6699.20-6699.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6699$1873
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<5>{0x13u});
	// \src: top.v:6643.20-6643.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6643$1861
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<4>{0xbu});
	// \src: top.v:6732.20-6732.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6732$1882
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1343__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<5>{0x10u});
	// \src: top.v:6730.20-6730.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6730$1881
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1340__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<5>{0x18u});
	// \src: top.v:6728.20-6728.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6728$1880
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1337__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<4>{0xeu});
	// \src: top.v:6647.20-6647.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6647$1863
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1262__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<3>{0x7u});
	// \src: top.v:6645.20-6645.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6645$1862
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1260__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<4>{0x9u});
	// \src: top.v:6639.20-6639.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6639$1859
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1250__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<4>{0x8u});
	// \src: top.v:6637.20-6637.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6637$1858
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1247__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<5>{0x17u});
	// \src: top.v:6635.20-6635.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6635$1857
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1244__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<5>{0x12u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:599$101 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3293
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4954__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4918__o.slice<3>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4947__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4947__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:491$77 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3277
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4866__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4830__o.slice<3>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4859__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4859__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:8355$2217 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:8349$2215 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:8353$2216
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n770__o = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<37>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<36>().val()));
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8099$2150 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$3249
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n489__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n447__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n482__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n482__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:649.20-649.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:649$114
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4767__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<2,0>().val(), value<1>{0x1u});
	// \src: top.v:5157.20-5157.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:5157$1656
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3052__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1518__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1795__o);
	// \src: top.v:5151.20-5151.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:5151$1653
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3043__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1522__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1516__o);
	// \src: top.v:1401.20-1401.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1401$413
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<2,0>().val(), value<3>{0x5u});
	// \src: top.v:1429.20-1429.28
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:1429$422
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3737__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<10>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4212$1372 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:4210$1371
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2353__o = (reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<73,70>().val()) ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:1700.20-1700.43
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1700$509
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4109__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<39,31>().val());
	// \src: top.v:1555.20-1555.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1555$459
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3892__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<6,3>().val(), value<2>{0x2u});
	// \src: top.v:1567.20-1567.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1567$465
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3907__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<6,3>().val(), value<3>{0x6u});
	// \src: top.v:1551.20-1551.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1551$457
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3889__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<6,3>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6514$1827 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2505 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2506_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6488$1819 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6494$1822 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6492$1821 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6490$1820 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6496$1823 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6498$1824
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1062__o ? value<2>{0u}.concat((eq_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o, value<3>{0x7u}).concat(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o, value<3>{0x4u})).concat(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o, value<2>{0x2u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o, value<4>{0x9u}))).concat(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o, value<1>{0x1u})).val(), value<4>{0x8u}) ? value<2>{0x3u} : value<2>{0x1u})).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<15,12>().val());
	// \full_case: 1
	// \src: top.v:6689.19-6689.19|top.v:6689.5-6693.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2480_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2480__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1285__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6690.33-6690.33|top.v:6689.5-6693.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2479_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2479__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1285__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:6716.19-6716.19|top.v:6716.5-6722.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2470_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2470__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1285__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:6717.35-6717.35|top.v:6716.5-6722.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2469_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2469__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1285__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:6718.35-6718.35|top.v:6716.5-6722.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2468_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2468__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1285__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6719.35-6719.35|top.v:6716.5-6722.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2467_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2467__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1285__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:6745.19-6745.19|top.v:6745.5-6751.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2458_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2458__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1343__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1340__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1337__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:6746.35-6746.35|top.v:6745.5-6751.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2457_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2457__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1343__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1340__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1337__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:6747.35-6747.35|top.v:6745.5-6751.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2456_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2456__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1343__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1340__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1337__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6748.35-6748.35|top.v:6745.5-6751.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2455_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2455__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1343__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1340__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1337__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:6657.34-6657.34|top.v:6651.5-6660.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2495_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2487__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1262__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1260__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1250__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1247__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1244__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:6656.34-6656.34|top.v:6651.5-6660.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2496_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2488__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1262__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1260__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1250__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1247__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1244__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6655.34-6655.34|top.v:6651.5-6660.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2497_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2489__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1262__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1260__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1250__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1247__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1244__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:6654.34-6654.34|top.v:6651.5-6660.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2498_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2490__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1262__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1260__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1250__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1247__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1244__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:6653.34-6653.34|top.v:6651.5-6660.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2499_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2491__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1262__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1260__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1250__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1247__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1244__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:6652.34-6652.34|top.v:6651.5-6660.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2500_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2492__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1262__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1260__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1250__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1247__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1244__o).val(), value<6>{0x20u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:7972$2128 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6560$1846 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:6558$1845 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6556$1844 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6550$1842 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6548$1841 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:7970$2127
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_advance = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<46>().val()), and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1149__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1152__o), not_u<1>(and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<47>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<48>().val()), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1161__o))));
	// \src: top.v:8155.19-8155.35
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:8155$2161
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n530__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<31>().val(), p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<8>().val());
	// \src: top.v:8473.19-8473.36
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:8473$2240
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n870__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<29,26>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$or$top.v:395$57 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$not$top.v:393$56
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_advance = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<25>().val()), p_unity__link__inst_2e_core__inst_2e_sent__ready.curr);
	// \full_case: 1
	// \src: top.v:5211.33-5211.33|top.v:5209.5-5214.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2652_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2652__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1693__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3052__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3043__o).val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5135$1646 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2723 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2720 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2709
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3032__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<109>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<13,3>().concat(value<3>{0x7u}).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2710__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<42,41>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2687__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3009__o.slice<13,12>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<13,12>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2687__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3009__o.slice<11,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<11,3>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2687__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3009__o.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2727__CMP ? value<3>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2692__CMP ? value<3>{0x3u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2691__CMP ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2549__o_5b_1_3a_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2724__CMP ? value<3>{0x1u} : value<3>{0x7u})))))).val());
	// \src: top.v:4635.20-4635.41
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$add$top.v:4635$1501
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2690__o = add_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<10,3>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4627$1499 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2804 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2848_CMP0
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2685__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<109>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<60,58>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2687__CMP ? value<3>{0x4u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1849__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1899__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1694__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1887__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<5>{0x10u}) ? value<3>{0x2u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<60,58>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4624$1498 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2810 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4401$1438
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2683__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<109>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<56>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2691__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2554__o ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2692__CMP ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<56>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4629$1500 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2797 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2849_CMP0
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2686__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<109>().val() ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2525__o_5b_2_3a_0_5d_).val() : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1849__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1899__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1694__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1887__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<6>{0x20u}) ? value<4>{0x6u} : value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2525__o_5b_2_3a_0_5d_).val()));
	// \src: top.v:2913.20-2913.34
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:2913$1211
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3482__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3626__q.curr, value<2>{0x2u});
	// \src: top.v:1445.20-1445.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1445$428
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3754__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<2,0>().val(), value<3>{0x4u});
	// \src: top.v:1435.20-1435.43
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:1435$424
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3741__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<39,31>().val());
	// \src: top.v:4242.20-4242.28
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:4242$1378
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2379__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2353__o);
	// \src: top.v:1710.20-1710.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1710$514
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4117__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4109__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3737__o);
	// \src: top.v:1575.20-1575.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1575$469
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3913__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<6,3>().val(), value<2>{0x3u});
	// \src: top.v:1659.20-1659.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1659$501
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4061__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<6,3>().val(), value<4>{0xbu});
	// \src: top.v:1655.20-1655.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1655$499
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4052__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<6,3>().val(), value<4>{0xau});
	// \src: top.v:1651.20-1651.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1651$497
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4043__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<6,3>().val(), value<4>{0x9u});
	// \src: top.v:1647.20-1647.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1647$495
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4034__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<6,3>().val(), value<4>{0x8u});
	// \src: top.v:1639.20-1639.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1639$491
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4016__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3892__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3907__o);
	// \src: top.v:1631.20-1631.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1631$487
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4004__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3889__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3904__o);
	// \src: top.v:1828.20-1828.45
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1828$555
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4113__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4109__o ? value<3>{0u} : value<3>{0x5u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7285$2018 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7281$2016 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7277$2014 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7273$2012
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1796__o = or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1690__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1786__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1789__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1693__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1795__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6800$1893 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$add$top.v:6796$1892
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<44>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<41,38>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<41,38>().val());
	// \src: top.v:6991.20-6991.35
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6991$1921
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1474__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left);
	// \src: top.v:7116.20-7116.42
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$add$top.v:7116$1966
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1635__o = add_uu<9>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<89,81>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6987$1919 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6982$1918 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2388
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1470__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o) ? value<11>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<91>().concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2389__CMP ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<90>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<89,81>()).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6409$1793 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6407$1792 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6405$1791
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1014__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<45,42>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<45,42>().val(), value<3>{0x6u}));
	// \src: top.v:6391.19-6391.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6391$1786
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n994__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<45,42>().val(), value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:6882.37-6882.37|top.v:6876.5-6885.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2431_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2431__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:6894.37-6894.37|top.v:6889.5-6898.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2428_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2428__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6906.37-6906.37|top.v:6902.5-6911.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2424_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2424__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:6918.37-6918.37|top.v:6915.5-6924.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2419_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2419__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:6930.37-6930.37|top.v:6928.5-6937.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2413_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2413__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:6942.37-6942.37|top.v:6941.5-6950.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2406_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2406__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<6>{0x20u});
	// \src: top.v:6753.20-6753.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6753$1885
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1359__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<4,0>().val(), value<5>{0x11u});
	// \src: top.v:6724.20-6724.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6724$1878
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1331__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<4,0>().val(), value<3>{0x4u});
	// \src: top.v:6695.20-6695.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6695$1871
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1301__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<4,0>().val());
	// \src: top.v:6674.20-6674.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6674$1866
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1282__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<4,0>().val(), value<5>{0x10u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:609$103 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3295
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4961__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4918__o.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4954__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4954__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:501$79 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3279
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4873__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4830__o.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4866__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4866__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:8159.19-8159.41
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:8159$2163
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n539__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<7,0>().val(), value<4>{0xdu});
	// \src: top.v:4172.20-4172.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4172$1360
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2300__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<2,0>().val(), value<3>{0x7u});
	// \src: top.v:1333.20-1333.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1333$392
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3654__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<2,0>().val());
	// \full_case: 1
	// \src: top.v:5177.33-5177.33|top.v:5175.5-5180.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2665
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3062__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2652__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3032__o.slice<13,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<13,3>().val());
	// \full_case: 1
	// \src: top.v:4810.38-4810.38|top.v:4809.5-4819.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2769
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2670__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2710__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<42,41>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2687__CMP ? value<2>{0x2u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<13,12>().val()));
	// \full_case: 1
	// \src: top.v:4786.38-4786.38|top.v:4779.5-4789.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2783
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2664__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2727__CMP ? value<3>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2692__CMP ? value<3>{0x3u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2691__CMP ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2549__o_5b_1_3a_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2724__CMP ? value<3>{0x1u} : value<3>{0x7u}))));
	// \src: top.v:1832.20-1832.46
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1832$557
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4115__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<10>().val() ? value<3>{0x4u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4113__o);
	// \src: top.v:1870.20-1870.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1870$572
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4322__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<2,0>().val(), value<3>{0x6u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7385$2052 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7381$2050
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1893__o = or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1887__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1690__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1693__o);
	// \full_case: 1
	// \src: top.v:6766.19-6766.19|top.v:6766.5-6772.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2446_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2446__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1359__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1331__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1301__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1282__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:6767.34-6767.34|top.v:6766.5-6772.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2445_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2445__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1359__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1331__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1301__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1282__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:6768.34-6768.34|top.v:6766.5-6772.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2444_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2444__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1359__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1331__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1301__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1282__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6769.34-6769.34|top.v:6766.5-6772.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2443_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2443__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1359__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1331__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1301__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1282__o).val(), value<1>{0x1u});
	// \src: top.v:8678.19-8678.38
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:8678$2269
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n240__o = and_uu<1>(p_in__valid, p_in__ready.curr);
	// cells $flatten\unity_link_inst.\core_inst.\rx_register_inst.$or$top.v:8566$2259 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:7978$2130 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:7976$2129 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$not$top.v:8568$2260
	p_unity__link__inst_2e_core__inst_2e_fifo__out__ready = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_character__valid.curr), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_advance, not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<33>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:8175$2167 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$not$top.v:8169$2165 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:8173$2166
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n554__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<29,26>().val(), value<4>{0xau}), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n530__o));
	// \src: top.v:8114.19-8114.39
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8114$2154
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<16>().val() ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8112$2153 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8109$2152 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$3251
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n498__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<16>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n461__o_5b_2_3a_0_5d_.slice<2>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n468__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n475__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n482__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n489__o_5b_2_3a_0_5d_.slice<2>()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n454__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n489__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n489__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val())).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<25,18>().val());
	// \src: top.v:4174.20-4174.41
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4174$1361
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2307__o = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2300__o ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1329$391 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$and$top.v:403$60 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:401$59 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:1327$390
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<88>().val()), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_advance, (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4767__o ? value<1>{0x1u} : value<1>{0u})));
	// \src: top.v:2983.20-2983.38
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ne$top.v:2983$1246
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3544__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_access__failure.curr);
	// \src: top.v:2901.20-2901.34
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:2901$1205
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3460__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3626__q.curr);
	// \src: top.v:4074.20-4074.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4074$1323
	p_unity__link__inst_2e_core__inst_2e_access__exclusive = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<18>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<57>().val());
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:2919$1214 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:2917$1213 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2915$1212
	p_unity__link__inst_2e_core__inst_2e_access__done = and_uu<1>((p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3482__o ? value<1>{0x1u} : value<1>{0u}), not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr));
	// \src: top.v:1856.20-1856.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1856$569
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4294__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<2,0>().val(), value<2>{0x2u});
	// \src: top.v:1737.20-1737.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1737$527
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4132__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<2,0>().val(), value<1>{0x1u});
	// \src: top.v:1686.20-1686.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1686$507
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4088__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<7,3>().val(), value<4>{0xeu});
	// memory \unity_link_inst.core_inst.frame_writer_inst.n4748 read port 0
	auto tmp_0 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<77,72>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_0.valid && "out of bounds read");
	if(tmp_0.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4749__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4748[tmp_0.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4749__data = value<4> {};
	}
	// \full_case: 1
	// \src: top.v:2158.19-2158.19|top.v:2158.5-2163.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3067_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3067__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4322__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3754__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3731__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:2159.36-2159.36|top.v:2158.5-2163.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3066_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3066__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4322__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3754__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3731__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:2160.33-2160.33|top.v:2158.5-2163.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3065_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3065__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4322__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3754__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3731__o).val(), value<1>{0x1u});
	// memory \unity_link_inst.core_inst.frame_writer_inst.n4754 read port 0
	auto tmp_1 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<77,72>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_1.valid && "out of bounds read");
	if(tmp_1.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4755__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4754[tmp_1.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4755__data = value<4> {};
	}
	// memory \unity_link_inst.core_inst.frame_writer_inst.n4752 read port 0
	auto tmp_2 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<77,72>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_2.valid && "out of bounds read");
	if(tmp_2.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4753__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4752[tmp_2.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4753__data = value<4> {};
	}
	// memory \unity_link_inst.core_inst.frame_writer_inst.n4750 read port 0
	auto tmp_3 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<77,72>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_3.valid && "out of bounds read");
	if(tmp_3.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4751__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4750[tmp_3.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4751__data = value<4> {};
	}
	// \src: top.v:1585.20-1585.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1585$474
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3932__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<6,3>().val(), value<4>{0xdu});
	// \src: top.v:1589.20-1589.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1589$476
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3941__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<6,3>().val(), value<4>{0xeu});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1577$470 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1573$468 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1571$467 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1569$466 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1565$464 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1561$462
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3914__o = or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<6,3>().val(), value<3>{0x4u}), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3904__o), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3907__o), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<6,3>().val(), value<3>{0x7u})), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3913__o);
	// \src: top.v:1581.20-1581.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1581$472
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3923__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<6,3>().val(), value<4>{0xcu});
	// \src: top.v:1593.20-1593.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1593$478
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3950__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<6,3>().val(), value<4>{0xfu});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1557$460 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1553$458 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1549$456
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3893__o = or_uu<1>(or_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<6,3>().val()), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3889__o), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3892__o);
	// \src: top.v:1531.20-1531.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1531$451
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3864__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<7,3>().val(), value<5>{0x11u});
	// \src: top.v:1529.20-1529.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1529$450
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3860__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<7,3>().val(), value<5>{0x10u});
	// \src: top.v:92.20-92.39
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:92$2
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5068__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<25>().val(), p_unity__link__inst_2e_core__inst_2e_sent__ready.curr);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7198$1988 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7186$1984 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7180$1982 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7174$1980 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7170$1979 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:7184$1983
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1695__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1694__o, and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<6>().val()), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1683__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<90>().val(), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<11,8>().val(), value<3>{0x4u})))));
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2508 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2509_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2510_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6389$1785 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$le$top.v:6387$1784 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6403$1790 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6401$1789 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ge$top.v:6395$1787 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$le$top.v:6399$1788
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1014__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n994__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<41,38>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1014__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n994__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<41,38>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<41,38>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u}));
	// \src: top.v:7166.20-7166.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7166$1978
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1161__o, p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<48>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:619$105 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3297
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4968__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4926__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4961__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4961__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:511$81 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3281
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4880__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4838__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4873__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4873__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:8680.19-8680.40
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:8680$2270
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n241__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr, p_unity__link__inst_2e_core__inst_2e_fifo__out__ready);
	// \src: top.v:8694.19-8694.40
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$eq$top.v:8694$2277
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n271__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8345$2214 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8337$2212 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8319$2208 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8317$2207 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8315$2206 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:8299$2203 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:8285$2199 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:8245$2187 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:8239$2186 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:8225$2182 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$2347 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$2348_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$2349_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8195$2172 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:8193$2171 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8209$2177 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:8207$2176 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ge$top.v:8201$2174 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:8205$2175 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:8237$2185 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8235$2184 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$add$top.v:8231$2183 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$2343 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$2344_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procmux$2345_CMP0 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8255$2189 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:8253$2188 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8269$2194 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:8267$2193 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ge$top.v:8261$2191 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$le$top.v:8265$2192 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:8297$2202 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8295$2201 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$add$top.v:8291$2200
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n762__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n554__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<53,48>().concat(value<2>{0u}).val() : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n539__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<53,48>().concat(value<2>{0u}).val() : value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n530__o ? value<4>{0x9u} : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<30>().val() ? value<4>{0x7u} : value<3>{0u}.concat((and_uu<1>(eq_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<6>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<3,0>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<3,0>().val()), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<25,22>().val()), and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n693__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n673__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<3,0>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n693__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n673__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<3,0>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<3,0>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<16>().val(), and_uu<1>(eq_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<14>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<11,8>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<11,8>().val()), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<21,18>().val()), and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n627__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n607__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<11,8>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n627__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n607__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<11,8>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<11,8>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<17>().val()))))) ? value<1>{0u} : value<1>{0x1u})).val()))).concat(value<3>{0x3u}).val()));
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$or$top.v:8161$2164 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:8157$2162
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n540__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<7,0>().val(), value<4>{0xau}), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n539__o);
	// \src: top.v:8469.19-8469.43
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8469$2239
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n867__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n770__o ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<45,38>()).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<7,0>()).val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8341$2213 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8326$2209 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8329$2210 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8333$2211
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n759__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n554__o ? value<22>{0x102800u} : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n539__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<37,34>().val() : value<4>{0x4u}).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n539__o ? value<1>{0x1u} : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n539__o ? value<1>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n530__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<30,16>()).val() : value<17>{0x2800u})).val());
	// \src: top.v:8465.19-8465.43
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8465$2238
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n864__o = (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n770__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<25,0>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n498__o.concat(value<1>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<17>()).concat(p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<7,0>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<15,8>()).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4104$1333 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4102$1332
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<46,39>().val(), value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4098$1331 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4096$1330
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2210__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2198__o) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4248$1381 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4246$1380 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4244$1379 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4240$1377
	p_unity__link__inst_2e_core__inst_2e_answer__has__id = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<20>().val(), (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2379__o, eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<19,16>().val(), value<4>{0xfu})) ? value<1>{0x1u} : value<1>{0u}));
	// \full_case: 1
	// \src: top.v:2406.19-2406.19|top.v:2406.5-2415.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2936_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2936__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4322__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3754__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3731__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4294__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4132__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3654__o).val(), value<7>{0x40u});
	// \full_case: 1
	// \src: top.v:2407.37-2407.37|top.v:2406.5-2415.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2935_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2935__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4322__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3754__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3731__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4294__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4132__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3654__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:2408.37-2408.37|top.v:2406.5-2415.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2934_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2934__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4322__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3754__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3731__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4294__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4132__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3654__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:2409.37-2409.37|top.v:2406.5-2415.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2933_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4322__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3754__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3731__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4294__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4132__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3654__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:2412.37-2412.37|top.v:2406.5-2415.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2930_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4322__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3754__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3731__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4294__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4132__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3654__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:2410.37-2410.37|top.v:2406.5-2415.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2932_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4322__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3754__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3731__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4294__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4132__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3654__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:2411.37-2411.37|top.v:2406.5-2415.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2931_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4322__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3754__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3731__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4294__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4132__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3654__o).val(), value<2>{0x2u});
	// \src: top.v:1682.20-1682.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1682$506
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4083__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<7,3>().val(), value<5>{0x12u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1798$550 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3084 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3085_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3086_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3087_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3088_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3089_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3090_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3091_CMP0
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4074__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<7>().val() ? value<5>{0u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4061__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4052__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4043__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4034__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3913__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4016__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4004__o).val(), value<1>{0x1u}) ? value<5>{0xdu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4061__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4052__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4043__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4034__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3913__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4016__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4004__o).val(), value<2>{0x2u}) ? value<5>{0x11u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4061__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4052__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4043__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4034__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3913__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4016__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4004__o).val(), value<3>{0x4u}) ? value<5>{0xbu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4061__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4052__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4043__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4034__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3913__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4016__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4004__o).val(), value<4>{0x8u}) ? value<5>{0x13u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4061__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4052__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4043__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4034__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3913__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4016__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4004__o).val(), value<5>{0x10u}) ? value<5>{0xeu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4061__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4052__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4043__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4034__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3913__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4016__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4004__o).val(), value<6>{0x20u}) ? value<5>{0x18u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4061__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4052__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4043__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4034__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3913__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4016__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4004__o).val(), value<7>{0x40u}) ? value<5>{0x10u} : value<5>{0u}))))))));
	// \full_case: 1
	// \src: top.v:1878.33-1878.33|top.v:1876.5-1881.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3079
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4325__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3065__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<18,15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3066__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<30,27>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3067__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4749__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<71,68>().val())));
	// \full_case: 1
	// \src: top.v:2160.33-2160.33|top.v:2158.5-2163.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3064
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4625__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3065__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<18,15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3066__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<30,27>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3067__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4755__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<71,68>().val())));
	// \full_case: 1
	// \src: top.v:2060.33-2060.33|top.v:2058.5-2063.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3069
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4521__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3065__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<18,15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3066__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<30,27>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3067__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4753__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<71,68>().val())));
	// \full_case: 1
	// \src: top.v:1974.33-1974.33|top.v:1972.5-1977.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3074
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4428__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3065__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<18,15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3066__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<30,27>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3067__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4751__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<71,68>().val())));
	// \src: top.v:108.20-108.41
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$eq$top.v:108$10
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5099__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<1>{0x1u});
	// \src: top.v:94.20-94.41
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:94$3
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5069__o = and_uu<1>(p_out__valid.curr, p_out__ready);
	// \src: top.v:678.20-678.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:678$121
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5018__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<2,0>().val(), value<2>{0x2u});
	// \src: top.v:680.20-680.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:680$122
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5023__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<2,0>().val(), value<2>{0x3u});
	// \src: top.v:684.20-684.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:684$123
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5032__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<2,0>().val(), value<3>{0x4u});
	// \src: top.v:545.20-545.37
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:545$90
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4904__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<2,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:8720$2290 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$not$top.v:8718$2289
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n289__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n241__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n240__o));
	// \src: top.v:8002.19-8002.34
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$eq$top.v:8002$2132
	p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n390__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<17,16>().val());
	// \src: top.v:4130.20-4130.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4130$1344
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2263__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<2,0>().val());
	// \src: top.v:5462.20-5462.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:5462$1744
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3266__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<2,0>().val(), value<3>{0x6u});
	// \src: top.v:5457.20-5457.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:5457$1742
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3261__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<2,0>().val(), value<3>{0x5u});
	// \src: top.v:5431.20-5431.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:5431$1735
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3235__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<2,0>().val(), value<3>{0x4u});
	// \src: top.v:5426.20-5426.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:5426$1733
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3230__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<2,0>().val(), value<2>{0x3u});
	// \src: top.v:5334.20-5334.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:5334$1704
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3155__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<2,0>().val(), value<2>{0x2u});
	// \src: top.v:5332.20-5332.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:5332$1703
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3151__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<2,0>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1339$395 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4224$1376 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:4222$1375 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1337$394 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1335$393
	p_unity__link__inst_2e_core__inst_2e_answer__taken = and_uu<1>(and_uu<1>((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3654__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2307__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<22>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4126$1343 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4124$1342
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__done, (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3544__o ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5272$1683 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5257$1677 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4878$1571 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2780 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5230$1668 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5221$1665 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2668 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2670_CMP0 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5234$1669 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5237$1670 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5241$1671 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4619$1496 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2840
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3108__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<14>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<109>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<13,12>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2690__o).concat(value<3>{0x7u}).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2670__o.concat(value<1>{0u}).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2687__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<24,17>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2690__o)).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2664__o).val()) : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<13,12>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3062__o.slice<10,9>().val()).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<15>().val() ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3062__o.slice<8>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<10,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3062__o.slice<7,0>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<15>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<11>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<2,0>().val() : value<3>{0x7u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2652__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3032__o.slice<2,0>().val() : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1693__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3052__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3043__o).val(), value<3>{0x4u}) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<2,0>().val() : value<3>{0x7u})))).val()) : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<109>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<13,3>().concat(value<3>{0x7u}).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2670__o.concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2687__CMP ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<24,17>()).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<11,3>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2664__o).val()));
	// \src: top.v:4374.20-4374.44
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:4374$1425
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2508__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<108,105>().val());
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:2905$1207 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2903$1206 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:2899$1204 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:2897$1203
	p_unity__link__inst_2e_core__inst_2e_access__granted = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<56>().val(), not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3499__o.curr)), (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3460__o ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4168$1359 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:4166$1358 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4120$1340 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4118$1339 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4116$1338
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2296__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__done, (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_access__failure.curr) ? value<1>{0x1u} : value<1>{0u})), not_u<1>(p_unity__link__inst_2e_core__inst_2e_access__exclusive));
	// cell $auto$opt_reduce.cc:131:opt_pmux$3405
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3343 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2934__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2935__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2936__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1854$568 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1848$565 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1842$562 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1830$556
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4126__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4083__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4088__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<9>().val() ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4117__o ? value<1>{0x1u} : value<1>{0u}))));
	// \src: top.v:1678.20-1678.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:1678$505
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4076__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4074__o);
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2126$632 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2119$629
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4586__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<39,31>().val(), value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3715__o);
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1850$566 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1844$563 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1838$560
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4124__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4083__o ? value<3>{0x5u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4088__o ? value<3>{0x6u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<9>().val() ? value<3>{0x3u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4115__o)));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1852$567 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1846$564 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1840$561
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4125__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4083__o ? value<6>{0x3u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4088__o ? value<6>{0x3fu} : value<2>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<9>().val() ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<22,19>().val() : value<4>{0x1u})).val()));
	// \src: top.v:1921.20-1921.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$sub$top.v:1921$581
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4365__o = sub_uu<6>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<77,72>().val(), value<1>{0x1u});
	// \src: top.v:2961.20-2961.48
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:2961$1235
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3632__q.curr);
	// \src: top.v:2981.20-2981.34
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:2981$1245
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3542__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3626__q.curr, value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:134$23 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$not$top.v:132$22
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5117__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5069__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5068__o));
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7566$2113 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7220$1993
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2057__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o ? value<1>{0x1u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1695__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<88,81>().concat(value<1>{0x1u}).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<100,93>().concat(value<1>{0u}).val())).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<101,93>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7160$1976 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7144$1973 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7132$1970 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2370 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2371_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7080$1955 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7086$1958 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7084$1957 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7082$1956 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7088$1959 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7090$1960 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$sub$top.v:6989$1920 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2433 $auto$opt_reduce.cc:131:opt_pmux$3388 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7150$1974 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2430 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2427 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2423 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2418 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2412 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2405 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2397 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6852$1903 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7124$1968 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7134$1971 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7119$1967 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7138$1972 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7128$1969
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<100,93>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<91,8>()).val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1474__o ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<88,81>().concat(value<1>{0x1u}).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<100,93>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<100,93>().concat(value<1>{0u}).val()).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1470__o.slice<10>()).concat((and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1474__o) ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<89>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1470__o.slice<8,0>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1635__o)).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1470__o.slice<9,0>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2389__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<90>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<76,73>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o).val() : value<4>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o).val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<80,73>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2406__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<68,57>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<72,57>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2413__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<52,49>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<56,49>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2419__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<44,41>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<48,41>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2424__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<36,33>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<40,33>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2428__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<28,25>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<32,25>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2431__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<20,17>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<24,17>().val())).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<100,93>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<91,17>()).val()).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2389__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2406__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2413__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2419__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2424__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2428__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2431__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<16>().val() : value<1>{0x1u}).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1474__o ? value<2>{0u}.concat((eq_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1593__o, value<3>{0x7u}).concat(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1593__o, value<3>{0x4u})).concat(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1593__o, value<2>{0x2u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1593__o, value<4>{0x9u}))).concat(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1593__o, value<1>{0x1u})).val(), value<4>{0x8u}) ? value<2>{0x3u} : value<2>{0x1u})).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1593__o).val() : sub_uu<4>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left, value<1>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field).val())).val() : value<1>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field).val())).val());
	// \full_case: 1
	// \src: top.v:732.35-732.35|top.v:729.5-736.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$3137_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3116__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5032__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5023__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5018__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4767__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4904__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:721.35-721.35|top.v:717.5-724.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$3143_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3115__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5032__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5023__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5018__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4767__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4904__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:730.35-730.35|top.v:729.5-736.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$3139_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3118__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5032__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5023__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5018__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4767__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4904__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:731.35-731.35|top.v:729.5-736.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$3138_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3117__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5032__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5023__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5018__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4767__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4904__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:729.19-729.19|top.v:729.5-736.12
	// cell $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$3140_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3119__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5032__o.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5023__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5018__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4767__o).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4904__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:5658.38-5658.38|top.v:5657.5-5667.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2528_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2528__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2300__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3266__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3235__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3230__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3155__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3151__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2263__o).val(), value<7>{0x40u});
	// \full_case: 1
	// \src: top.v:5660.38-5660.38|top.v:5657.5-5667.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2526_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2526__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2300__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3266__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3235__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3230__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3155__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3151__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2263__o).val(), value<5>{0x10u});
	// \src: top.v:5435.20-5435.44
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:5435$1736
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3240__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<54,47>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<117,110>().val());
	// \full_case: 1
	// \src: top.v:5657.19-5657.19|top.v:5657.5-5667.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2529_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2529__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2300__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3266__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3235__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3230__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3155__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3151__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2263__o).val(), value<8>{0x80u});
	// \full_case: 1
	// \src: top.v:5659.38-5659.38|top.v:5657.5-5667.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2527_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2527__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2300__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3266__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3235__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3230__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3155__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3151__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2263__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:5661.38-5661.38|top.v:5657.5-5667.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2525_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2300__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3266__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3235__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3230__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3155__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3151__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2263__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:5662.38-5662.38|top.v:5657.5-5667.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2524_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2524__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2300__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3266__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3235__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3230__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3155__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3151__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2263__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:5663.38-5663.38|top.v:5657.5-5667.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2523_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2300__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3266__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3235__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3230__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3155__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3151__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2263__o).val(), value<2>{0x2u});
	// \src: top.v:5342.20-5342.41
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$add$top.v:5342$1706
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3160__o = add_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<54,47>().val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:5664.38-5664.38|top.v:5657.5-5667.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2522_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2300__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3266__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3261__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3235__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3230__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3155__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3151__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2263__o).val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1463$435 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1461$434 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1459$433 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1457$432 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1451$430 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1441$427 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1439$426 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1437$425 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1431$423 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1425$421 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1415$418 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1413$417 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1407$415 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:1411$416
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance, or_uu<1>(or_uu<1>((and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<39,31>().val(), value<1>{0x1u}), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3715__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o)) ? value<1>{0x1u} : value<1>{0u}), (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3741__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3737__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3715__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3731__o))) ? value<1>{0x1u} : value<1>{0u})), (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3741__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3715__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3754__o)) ? value<1>{0x1u} : value<1>{0u})));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1509$444 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1467$436 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4266$1387 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4262$1385 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:4260$1384 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:4256$1383 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4346$1417 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4314$1407 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2852 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4306$1405 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4304$1404 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4302$1403 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4300$1402 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4298$1401 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4296$1400 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4294$1399 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4292$1398 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4290$1397 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4288$1396 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4286$1395 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4282$1393 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4278$1391 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4274$1389 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1471$437 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4338$1415 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4348$1418 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4252$1382
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3838__o = (p_unity__link__inst_2e_core__inst_2e_answer__taken ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2353__o ? value<4>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<73,70>()).val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<19>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<48,41>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<117,110>().val())).concat(value<4>{0x1u}).concat((p_unity__link__inst_2e_core__inst_2e_answer__has__id ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<74>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<10,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<30,23>().val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<32,25>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2353__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<20>().val() ? value<1>{0u} : (or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<19,16>().val(), value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2210__o), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2195__o), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2198__o), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<19,16>().val(), value<4>{0x8u})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<19,16>().val(), value<4>{0x9u})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<19,16>().val(), value<4>{0xau})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<19,16>().val(), value<4>{0xbu})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<19,16>().val(), value<4>{0xcu})) ? value<1>{0x1u} : value<1>{0u})))).concat(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_answer__has__id, and_uu<1>(and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<20>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<19>().val())), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2379__o))).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<30,9>().val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$3386
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3319 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2934__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2935__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2936__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1505$443 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4344$1416 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4336$1414
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3835__o = (p_unity__link__inst_2e_core__inst_2e_answer__taken ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<20>().concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2353__o ? value<5>{0x10u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<74>().val() ? value<5>{0x11u} : value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<19,16>()).val()))).concat(value<3>{0x1u}).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<8,0>().val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$3316
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3317 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP).val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$3350
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3349 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2934__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2936__CMP).val());
	// \src: top.v:1519.20-1519.51
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1519$447
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3845__o = (p_unity__link__inst_2e_core__inst_2e_answer__taken ? value<2>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<79,78>().val());
	// cells $flatten\unity_link_inst.\wishbone_master_inst.$and$top.v:8873$2330 $flatten\unity_link_inst.\wishbone_master_inst.$or$top.v:8871$2329
	p_unity__link__inst_2e_bus__done = and_uu<1>(p_wb__stb.curr, or_uu<1>(p_wb__ack, p_wb__err));
	// \full_case: 1
	// \src: top.v:3098.19-3098.19|top.v:3098.5-3103.12
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2867_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2867__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3482__o.concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3542__o).concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3460__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:3099.35-3099.35|top.v:3098.5-3103.12
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2866_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2866__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3482__o.concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3542__o).concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3460__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:3100.33-3100.33|top.v:3098.5-3103.12
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2865_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3482__o.concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3542__o).concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3460__o).val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:537$87 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:532$86 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$eq$top.v:529$85 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$add$top.v:525$84 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:521$83 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3283
	p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4899__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<88>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4852__o_5b_2_3a_0_5d_.slice<2>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4859__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4866__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4873__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4880__o_5b_2_3a_0_5d_.slice<2>()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4845__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4880__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4880__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val())).concat(add_uu<2>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<4,3>().val(), value<1>{0x1u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<4,3>().val(), value<2>{0x2u}) ? value<3>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<2,0>().val())).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<12,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:8710$2285 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$not$top.v:8708$2284
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n281__o = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n241__o), p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n240__o);
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:8700$2280 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$or$top.v:8698$2279 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:8696$2278 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$eq$top.v:8692$2276
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n274__o = and_uu<1>(or_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n241__o, p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n271__o)), p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n240__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5312$1696 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5288$1689 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5292$1690
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3135__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<102>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2508__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<13,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3108__o.slice<13,3>().val()).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2508__o ? value<3>{0x7u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3108__o.slice<2,0>().val())).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<13,0>().val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$3407
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3355 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2524__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2526__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2527__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2528__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2529__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5315$1697 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5294$1691 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5274$1684
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3137__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<102>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<117,110>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<32,17>()).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<104,103>()).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2508__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<5>().val() ? value<1>{0x1u} : value<1>{0u}))).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<3,0>()).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<46,16>().val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$3368
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3357 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2524__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2526__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2527__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2528__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2529__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5317$1698 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5297$1692 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5276$1685 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5261$1679 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5246$1673 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2658 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5300$1693 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5278$1686 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5263$1680 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5249$1674 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2655
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3138__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<102>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2508__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<60,58>().val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<14>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2685__o : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<60,58>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2652__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2685__o : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<60,58>().val()))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2685__o)).concat(value<1>{0u}).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2508__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<56>().val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<14>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2683__o : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<56>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2652__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2683__o : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<56>().val()))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2683__o))).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<60,56>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5320$1699 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5303$1694 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5281$1687 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5266$1681 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5251$1675 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2651 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2653_CMP0 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5306$1695 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5284$1688 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5269$1682 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5253$1676 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5226$1667
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3140__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<102>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2508__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<14>().val() ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<15>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<11>().val() ? value<1>{0u} : value<1>{0x1u}) : value<1>{0u})) : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2508__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<108,105>().val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<14>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2686__o : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<15>().val() ? value<4>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2652__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2686__o : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1693__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3052__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3043__o).val(), value<2>{0x2u}) ? value<4>{0x8u} : value<4>{0u})))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2686__o))).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<74,70>().val());
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:3226$1296 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4188$1366 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4186$1365 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:3224$1295 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$add$top.v:3222$1294
	p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3386__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2307__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<22>().val())) ? p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.curr : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2296__o ? add_uu<2>(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3419__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3419__q.curr));
	// cell $auto$opt_reduce.cc:131:opt_pmux$3336
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3331 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2866__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2867__CMP).val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$3340
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3339 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2867__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:114$13 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$or$top.v:112$12 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:110$11 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$eq$top.v:106$9
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5102__o = and_uu<1>(or_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5069__o, p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5099__o)), p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5068__o);
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:124$18 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$not$top.v:122$17
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5109__o = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5069__o), p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5068__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7597$2121 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4132$1345
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2079__o = and_uu<1>((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2263__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<102>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7593$2120 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6538$1837 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6532$1834 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7575$2115 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7155$1975 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6774$1888 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2448 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2494 $auto$opt_reduce.cc:131:opt_pmux$3384 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2482 $auto$opt_reduce.cc:131:opt_pmux$3396 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2472 $auto$opt_reduce.cc:131:opt_pmux$3394 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2460 $auto$opt_reduce.cc:131:opt_pmux$3390 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2442 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2486 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2478 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2466 $auto$opt_reduce.cc:131:opt_pmux$3392 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2454 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6782$1889 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6790$1891 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:6788$1890 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7578$2116 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7216$1992 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7562$2112 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7211$1991 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7581$2117 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7585$2118 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7589$2119 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7569$2114 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7558$2111 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:7403$2057 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7556$2110 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7435$2067 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7417$2061 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:7407$2058 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:7415$2060 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7413$2059 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:7433$2066 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7431$2065 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7429$2064 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7423$2062 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7554$2109 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7550$2107 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2351 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2352_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2353_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2354_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7517$2098 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7513$2096 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7509$2094 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7505$2092 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7497$2088 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7511$2095 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7507$2093 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7477$2081 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7499$2089 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7495$2087 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7533$2102 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:7523$2100 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7531$2101 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7367$2045 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2360 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2361_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2362_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2363_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2364_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2365_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7242$2000 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:7240$1999 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7265$2008 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7258$2007 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:7254$2005 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:7256$2006 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7322$2029 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7315$2028 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:7313$2027 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7309$2026 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7303$2024 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7301$2023 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7297$2022 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:7295$2021 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:7346$2039 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2356 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2357_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2358_CMP0
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2077__o = (and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<46>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1149__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1152__o) ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<47>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<117,102>().val() : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1899__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1893__o).val(), value<1>{0x1u}) ? value<8>{0x1u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1899__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1893__o).val(), value<2>{0x2u}) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<88,81>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<40,33>().val())).concat(((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1849__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1796__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<1>{0x1u}) ? or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1752__o, gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<40,33>().val(), value<1>{0x1u})) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1849__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1796__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<2>{0x2u}) ? or_uu<1>(and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<3,0>().val(), value<2>{0x3u}), gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<89,81>().val(), value<1>{0x1u})), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<91>().val()) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1849__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1796__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<3>{0x4u}) ? or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1799__o, reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<56,55>().concat(value<2>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<52,50>()).concat(value<1>{0u}).val())), logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<72,57>().val())), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1752__o), gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<40,33>().val(), value<6>{0x20u})), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<91>().val()) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1849__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1796__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<4>{0x8u}) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1799__o : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1849__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1796__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<5>{0x10u}) ? gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<48,41>().val(), value<2>{0x2u}) : value<1>{0u}))))) ? value<1>{0x1u} : value<1>{0u})).concat((reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<52,49>().val()) ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<52,49>().val() : (and_uu<1>(not_u<1>(and_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<3,0>().val(), value<4>{0xeu}), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<5>().val())), and_uu<1>(not_u<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<6>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<7>().val())), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<4>().val()))) ? value<2>{0u}.concat(((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<16>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1946__o : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1437__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1954__o).val(), value<1>{0x1u}) ? value<1>{0x1u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1437__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1954__o).val(), value<2>{0x2u}) ? ((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<16>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1965__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1795__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1998__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1940__o)))) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1965__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1795__o ? eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<89,81>().val(), value<2>{0x2u}) : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1998__o ? eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<89,81>().val(), value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1946__o)))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1437__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1954__o).val(), value<3>{0x4u}) ? and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<89,81>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<40,33>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<90>().val())) : value<1>{0u})))) ? value<2>{0u} : value<2>{0x3u})).val() : value<4>{0x2u}))).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<53>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<48>()).concat(value<1>{0x1u}).val()).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2057__o.slice<9>()).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<117,101>().val()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<47>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2057__o.slice<8,0>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o.slice<92,84>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<47>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<91>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o.slice<83>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<47>().val() ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1695__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o) ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<89>().val() ? value<1>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<88,81>()).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1635__o)).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<90,81>().val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o.slice<82,73>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<47>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<80,0>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o.slice<72,0>().concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter ? or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<7>().val(), not_u<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<43>().val())).concat(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<6>().val(), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<43>().val())).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<43>()).concat(((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2443__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2487__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2488__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2489__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2490__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2491__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2492__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2444__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2479__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2480__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2445__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2467__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2468__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2469__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2470__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2446__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2455__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2456__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2457__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2458__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : value<1>{0x1u})))) ? value<5>{0x1fu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2443__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2487__CMP ? value<5>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2488__CMP ? value<5>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2489__CMP ? value<5>{0xdu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2490__CMP ? value<5>{0xeu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2491__CMP ? value<5>{0xfu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2492__CMP ? value<5>{0x1fu} : value<5>{0u})))))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2444__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2479__CMP ? value<5>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2480__CMP ? value<5>{0x1fu} : value<5>{0u})) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2445__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2469__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2470__CMP).val()) ? value<5>{0x1fu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2468__CMP ? value<5>{0x7u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2467__CMP ? value<5>{0x5u} : value<5>{0u}))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2446__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2455__CMP ? value<5>{0x8u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2456__CMP ? value<5>{0x9u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2457__CMP ? value<5>{0xau} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2458__CMP ? value<5>{0xbu} : value<5>{0u})))) : value<5>{0u})))))).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<7,0>().val())).val())).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<117,93>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<91,0>()).val());
	// memory \unity_link_inst.core_inst.rx_fifo_inst.memory read port 0
	auto tmp_4 = memory_index(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n329__q.curr, 0, 256);
	CXXRTL_ASSERT(tmp_4.valid && "out of bounds read");
	if(tmp_4.valid) {
		value<9> tmp_5 = memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory[tmp_4.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_8778_24_2315__DATA = tmp_5;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_8778_24_2315__DATA = value<9> {};
	}
	// memory \unity_link_inst.core_inst.tx_fifo_inst.memory read port 0
	auto tmp_6 = memory_index(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5157__q.curr, 0, 256);
	CXXRTL_ASSERT(tmp_6.valid && "out of bounds read");
	if(tmp_6.valid) {
		value<10> tmp_7 = memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory[tmp_6.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_192_24_48__DATA = tmp_7;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_192_24_48__DATA = value<10> {};
	}
	// \full_case: 1
	// \src: top.v:5694.9-5694.14|top.v:5694.5-5695.41
	// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procmux$2512
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_5695_24_1764__EN_5b_7_3a_0_5d__24_1770_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<92>().val() ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:194.9-194.13|top.v:194.5-195.35
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$3166
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_195_24_1__EN_5b_9_3a_0_5d__24_52_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5068__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:8780.9-8780.13|top.v:8780.5-8781.35
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$2332
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_8781_24_2268__EN_5b_8_3a_0_5d__24_2319_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n240__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:3272.9-3272.14|top.v:3272.5-3273.37
	// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procmux$2855
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_3273_24_1293__EN_5b_7_3a_0_5d__24_1319_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2296__o ? value<1>{0x1u} : value<1>{0u});
	// memory \unity_link_inst.core_inst.response_ring_inst.memory read port 0
	auto tmp_8 = memory_index(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3421__q.curr.slice<0>().val(), 0, 2);
	CXXRTL_ASSERT(tmp_8.valid && "out of bounds read");
	if(tmp_8.valid) {
		value<8> tmp_9 = memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory[tmp_8.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3426__data_5b_7_3a_0_5d_ = tmp_9;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3426__data_5b_7_3a_0_5d_ = value<8> {};
	}
	// memory \unity_link_inst.core_inst.request_memory_inst.memory read port 0
	auto tmp_10 = memory_index(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<47>().val(), 0, 2);
	CXXRTL_ASSERT(tmp_10.valid && "out of bounds read");
	if(tmp_10.valid) {
		value<8> tmp_11 = memory_p_unity__link__inst_2e_core__inst_2e_request__memory__inst_2e_memory[tmp_10.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2158__data_5b_7_3a_0_5d_ = tmp_11;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2158__data_5b_7_3a_0_5d_ = value<8> {};
	}
	// memory \unity_link_inst.core_inst.request_memory_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:5694.9-5694.14|top.v:5694.5-5695.41
		// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procmux$2518
		auto tmp_12 = memory_index((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<92>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<93>().val() : value<1>{0u}), 0, 2);
		CXXRTL_ASSERT(tmp_12.valid && "out of bounds write");
		if (tmp_12.valid) {
			// \full_case: 1
			// \src: top.v:5694.9-5694.14|top.v:5694.5-5695.41
			// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procmux$2515
			memory_p_unity__link__inst_2e_core__inst_2e_request__memory__inst_2e_memory.update(tmp_12.index, (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<92>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<80,73>().val() : value<8>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_5695_24_1764__EN_5b_7_3a_0_5d__24_1770_5b_0_5d_.repeat<8>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.tx_fifo_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:194.9-194.13|top.v:194.5-195.35
		// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$3172
		auto tmp_13 = memory_index((p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5068__o ? p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5156__q.curr : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_13.valid && "out of bounds write");
		if (tmp_13.valid) {
			// \full_case: 1
			// \src: top.v:194.9-194.13|top.v:194.5-195.35
			// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$3169
			memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory.update(tmp_13.index, (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5068__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<24,15>().val() : value<10>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_195_24_1__EN_5b_9_3a_0_5d__24_52_5b_0_5d_.repeat<10>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.rx_fifo_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:8780.9-8780.13|top.v:8780.5-8781.35
		// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$2338
		auto tmp_14 = memory_index((p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n240__o ? p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n328__q.curr : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_14.valid && "out of bounds write");
		if (tmp_14.valid) {
			// \full_case: 1
			// \src: top.v:8780.9-8780.13|top.v:8780.5-8781.35
			// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$2335
			memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory.update(tmp_14.index, (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n240__o ? p_in__lost.concat(p_in__data).val() : value<9>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_8781_24_2268__EN_5b_8_3a_0_5d__24_2319_5b_0_5d_.repeat<9>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.response_ring_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:3272.9-3272.14|top.v:3272.5-3273.37
		// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procmux$2861
		auto tmp_15 = memory_index((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2296__o ? p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3419__q.curr.slice<0>().val() : value<1>{0u}), 0, 2);
		CXXRTL_ASSERT(tmp_15.valid && "out of bounds write");
		if (tmp_15.valid) {
			// \full_case: 1
			// \src: top.v:3272.9-3272.14|top.v:3272.5-3273.37
			// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procmux$2858
			memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory.update(tmp_15.index, (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2296__o ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3634__q.curr : value<8>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_3273_24_1293__EN_5b_7_3a_0_5d__24_1319_5b_0_5d_.repeat<8>().val(), 0);
		}
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$3187 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8740$2300 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8686$2273 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$add$top.v:8684$2272
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n328__q.next = (p_rst ? value<8>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n240__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n328__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n328__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$3186 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8742$2301 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8690$2275 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$add$top.v:8688$2274
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n329__q.next = (p_rst ? value<8>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n241__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n329__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n329__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$3185 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8744$2302 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8734$2297 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$add$top.v:8712$2286 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8728$2294 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$sub$top.v:8722$2291
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n281__o ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<1>{0x1u}) : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n289__o ? sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$3184 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8746$2303 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8736$2298 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8726$2293 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:8730$2295
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n281__o ? value<1>{0x1u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n271__o, p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n289__o) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$3183 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8748$2304 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8738$2299 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8716$2288 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$eq$top.v:8714$2287 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8732$2296
	if (posedge_p_clk) {
		p_in__ready.next = (p_rst ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n281__o ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<8>{0xffu}) ? value<1>{0u} : p_in__ready.curr) : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n289__o ? value<1>{0x1u} : p_in__ready.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$3182 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8750$2305 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8704$2282
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n274__o ? p_in__lost.concat(p_in__data).val() : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$3181 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8752$2306 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8706$2283 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8702$2281
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n336__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n274__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n241__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n336__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$3180 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$2340
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n337__data.next = (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n241__o ? i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_8778_24_2315__DATA : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n337__data.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_register_inst.$procdff$3189 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:8578$2265 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:8574$2263
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_character__valid.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_fifo__out__ready ? p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr : p_unity__link__inst_2e_core__inst_2e_character__valid.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_register_inst.$procdff$3188 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:8576$2264 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:8572$2262 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8682$2271
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_character__in.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_fifo__out__ready ? (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n336__q.curr ? p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.curr : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n337__data.curr) : p_unity__link__inst_2e_core__inst_2e_character__in.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$procdff$3190 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8532$2256 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8530$2255 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8528$2254 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8130$2155 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8134$2156 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8138$2157 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8142$2158 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8146$2159 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8151$2160 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8017$2135 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8015$2134 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8525$2253 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8497$2247 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8501$2248 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8492$2246 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8486$2244 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$sub$top.v:8480$2242 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8476$2241 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$and$top.v:8488$2245 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8357$2218 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8506$2249 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8510$2250 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8514$2251 $flatten\unity_link_inst.\core_inst.\with_datalink_rx_datalink_rx_inst.$ternary$top.v:8519$2252
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.next = (p_rst ? value<54>{0x28000000u,0x10u} : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_advance ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<33>().val() ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n390__o ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<31>().val() ? value<4>{0x9u} : value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<30>().val() ? value<3>{0x7u} : value<3>{0u})).val())).concat(value<2>{0x3u}).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<53,48>().concat(value<1>{0u}).val()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n390__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n499__o)).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n390__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<45,38>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<7,0>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n390__o ? value<12>{0x40au} : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<37,34>().concat(value<1>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<32,26>()).val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n390__o ? value<10>{0u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n498__o.concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<17>()).val())).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<15,8>()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n390__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<7,0>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<15,8>().val())).val() : (p_unity__link__inst_2e_core__inst_2e_character__valid.curr ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n540__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n762__o.slice<7,1>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<53,48>().concat(value<1>{0u}).val()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n540__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n762__o.slice<0>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n867__o.slice<8>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n540__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<45,38>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n867__o.slice<7,0>().val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n540__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n759__o.slice<21,15>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<37,34>().concat(value<2>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n530__o).val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n540__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n759__o.slice<14,0>().val() : (p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n770__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<30,26>().val() : (and_uu<1>((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n770__o ? value<1>{0u} : value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n870__o) ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<30>().val()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n870__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<29,26>().val() : sub_uu<4>(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<29,26>().val(), value<1>{0x1u}))).val()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n864__o.slice<25,16>()).val())).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n540__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<15,0>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n864__o.slice<15,0>().val())).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<53,48>().concat(value<2>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<45,34>()).concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr.slice<32,0>()).val())) : p_unity__link__inst_2e_core__inst_2e_with__datalink__rx__datalink__rx__inst_2e_n920__q.curr));
	}
	// \src: top.v:5675.3-5676.28
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procdff$3196
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.next = p_unity__link__inst_2e_core__inst_2e_memory__word.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procdff$3197 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5670$1761 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2641 $auto$opt_reduce.cc:131:opt_pmux$3378 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5469$1746 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:5466$1745 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5445$1738 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5414$1728 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5394$1722 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5375$1716 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5372$1715 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:5370$1714 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5327$1701 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2631 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4354$1420 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4352$1419 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:4363$1422 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$sub$top.v:4359$1421 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2621 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2611 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2601 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2591 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5419$1730 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5400$1724 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5366$1713 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$add$top.v:5363$1712 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$sub$top.v:5357$1710 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2581 $auto$opt_reduce.cc:131:opt_pmux$3366 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5448$1739 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5345$1707 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:5338$1705 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4369$1424 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ge$top.v:4367$1423 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2571 $auto$opt_reduce.cc:131:opt_pmux$3364 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5422$1731 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5403$1725 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5378$1717 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5330$1702 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2561 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2551 $auto$opt_reduce.cc:131:opt_pmux$3360 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5451$1740 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2541 $auto$opt_reduce.cc:131:opt_pmux$3358 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5455$1741 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2531 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5410$1727 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:5424$1732 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2521
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.next = (p_rst ? value<75>{0xd2000u,0x8000000u,0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3355 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<74>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3140__o.slice<4>().val() : value<1>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed, p_unity__link__inst_2e_core__inst_2e_access__done) ? p_unity__link__inst_2e_core__inst_2e_access__failure.curr : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<73,70>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3357 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<73,70>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3140__o.slice<3,0>().val() : value<4>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2527__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3240__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<69,62>().concat(value<1>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<54,47>().concat(value<1>{0x1u}).val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2524__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2526__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2528__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2529__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<69,62>().concat(value<1>{0u}).val() : value<9>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2527__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3240__o ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<60,58>().val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2524__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2526__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2528__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2529__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<60,58>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3138__o.slice<4,2>().val() : value<3>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3138__o.slice<1>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3355 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<57>().val() : value<1>{0u}))).concat((reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2526__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2527__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2528__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2529__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<56>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__done ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<56>().val())) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<56>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2524__CMP ? value<1>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<55>().val() ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<56>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3138__o.slice<0>().val() : value<1>{0u})))))).concat((ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.curr, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<117,110>().val()) ? value<1>{0x1u} : value<1>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2527__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3240__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<54,47>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3160__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<18>().val(), p_unity__link__inst_2e_core__inst_2e_access__granted) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3160__o : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<54,47>().val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2524__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2526__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2528__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2529__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<54,47>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP ? value<8>{0u} : value<8>{0u}))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__done ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<46,31>().val() : sub_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<46,39>().val(), value<1>{0x1u}).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<38,31>().val() : add_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<38,31>().val(), value<1>{0x1u}))).val()) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<46,31>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3357 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<46,31>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3137__o.slice<30,15>().val() : value<16>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3355 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<30,21>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3137__o.slice<14,5>().val() : value<10>{0u}))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3355 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<20>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3137__o.slice<4>().val() : value<1>{0u}))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3355 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<19,16>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3137__o.slice<3,0>().val() : value<4>{0u}))).concat(not_u<1>(sub_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<24,17>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<10,3>().val()).slice<7>().val())).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<24,17>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<10,3>().val()) ? value<1>{0x1u} : value<1>{0u})).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3355 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<13,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3135__o.slice<13,3>().val() : value<11>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2529__CMP ? (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_answer__taken, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<22>().val()) ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2527__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3240__o ? value<3>{0x7u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<2,0>().val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2526__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2528__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__done ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? value<3>{0x7u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<19,16>().val(), value<3>{0x7u}) ? value<3>{0u} : value<3>{0x7u}) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<2,0>().val())) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2524__CMP ? value<3>{0x3u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<55>().val() ? value<3>{0x3u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3135__o.slice<2,0>().val() : value<3>{0u})))))))).val());
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$3206 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:3246$1306
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3419__q.next = (p_rst ? value<2>{0u} : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3386__o);
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$3205 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:3248$1307 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:3228$1297 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4176$1362
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.next = (p_rst ? value<2>{0u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2307__o, p_unity__link__inst_2e_core__inst_2e_answer__taken) ? p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3386__o : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$3204 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:3250$1308 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:3232$1299 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1371$407 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:1369$406 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$add$top.v:3230$1298
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3421__q.next = (p_rst ? value<2>{0u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word, not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<78>().val())) ? add_uu<2>(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3421__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3421__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$3203 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:3242$1304 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$sub$top.v:3236$1301 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$sub$top.v:3234$1300
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.next = (p_rst ? value<2>{0x2u} : sub_uu<2>(value<2>{0x2u}, sub_uu<2>(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3419__q.curr, p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3421__q.curr)));
	}
	// \src: top.v:3268.3-3270.37
	// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$3201
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3426__data_5b_7_3a_0_5d_;
	}
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procdff$3220 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2428$672 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2426$671 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3055 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1730$524 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1946$590 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2032$610 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2122$630 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2210$651 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3046 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3037 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3028 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1902$578 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3019 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3010 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1913$580 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3001 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2129$633 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$sub$top.v:2111$627 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1513$445 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4330$1413 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4328$1412 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4322$1410 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:4320$1409 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4326$1411 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2423$670 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2421$669 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2992 $auto$opt_reduce.cc:131:opt_pmux$3344 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2983 $auto$opt_reduce.cc:131:opt_pmux$3399 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2131$634 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2115$628 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1948$591 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1733$525 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2974 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2965 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2134$635 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2956 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1609$481 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3110 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3111_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3112_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3102 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3103_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3104_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3105_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3106_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3107_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3108_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1891$576 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:1883$574 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:1887$575 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1987$600 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:1979$598 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:1983$599 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2073$620 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:2065$618 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:2069$619 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2173$644 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:2165$642 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:2169$643 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2947 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2938 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1735$526 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1937$586 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1950$592 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2029$609 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2036$612 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2124$631 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2212$652 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2929 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1521$448
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.next = (p_rst ? value<93>{0u,0u,0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance ? (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3319 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<92,90>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP ? (p_unity__link__inst_2e_core__inst_2e_answer__taken ? value<2>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<21>()).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<92,90>().val()) : value<3>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4076__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4126__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4126__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4117__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3715__o) ? value<1>{0x1u} : value<1>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2934__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4109__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3715__o) ? value<1>{0x1u} : value<1>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2935__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4586__o ? value<1>{0x1u} : value<1>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2936__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3715__o ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})))))))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3319 ? value<1>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP ? value<1>{0u} : value<1>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<87,80>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP ? value<2>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<8>()).concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<7>().val() ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3864__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3860__o).val(), value<1>{0x1u}) ? value<5>{0x18u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3864__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3860__o).val(), value<2>{0x2u}) ? value<5>{0xeu} : value<5>{0x10u})) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3950__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3941__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3932__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3923__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3914__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3893__o).val(), value<1>{0x1u}) ? value<5>{0x12u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3950__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3941__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3932__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3923__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3914__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3893__o).val(), value<2>{0x2u}) ? value<5>{0x17u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3950__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3941__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3932__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3923__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3914__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3893__o).val(), value<3>{0x4u}) ? value<5>{0x9u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3950__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3941__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3932__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3923__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3914__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3893__o).val(), value<4>{0x8u}) ? value<5>{0x8u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3950__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3941__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3932__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3923__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3914__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3893__o).val(), value<5>{0x10u}) ? value<5>{0x11u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3950__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3941__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3932__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3923__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3914__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3893__o).val(), value<6>{0x20u}) ? value<5>{0xbu} : value<5>{0x7u})))))))).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP ? value<2>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4074__o).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4325__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4325__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4325__o).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2934__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4428__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4428__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4428__o).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2935__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4521__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4521__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4521__o).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2936__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4625__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4625__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4625__o).val()) : value<8>{0u})))))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2935__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3715__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<79>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3349 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<79>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3845__o.slice<1>().val() : value<1>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3319 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<78>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3845__o.slice<0>().val() : value<1>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2936__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4365__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2935__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3715__o ? value<3>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<79>().val() ? value<3>{0x7u} : value<3>{0x1u})).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4365__o) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2934__CMP).val()) ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3715__o ? value<6>{0x1u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4365__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4125__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4076__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<77,72>().val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4125__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<77,72>().val() : value<6>{0u}))))))).concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<78>().val() ? value<32>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word.curr.concat(value<24>{0u}).val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3343 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<67,40>().concat(value<4>{0u}).val() : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<71,40>().val() : value<32>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2935__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3715__o ? sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<39,31>().val(), value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<39,31>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3349 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<39,31>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP ? (p_unity__link__inst_2e_core__inst_2e_answer__taken ? value<1>{0u}.concat((and_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<19,18>().val()), and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<74>().val()), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2379__o)) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<117,110>().val() : value<8>{0u})).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<39,31>().val()) : value<9>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3838__o.slice<21,14>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3317 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<30,23>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3343 ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3754__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<26,23>().concat(value<4>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<30,23>().val()) : value<8>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3319 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<22,19>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3838__o.slice<13,10>().val() : value<4>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3838__o.slice<9,2>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3317 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<18,11>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3343 ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3731__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<14,11>().concat(value<4>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<18,11>().val()) : value<8>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3319 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<10,9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3838__o.slice<1,0>().val() : value<2>{0u}))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3319 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<8,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3835__o.slice<8,3>().val() : value<6>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3835__o.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4076__o ? value<3>{0x2u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4124__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4124__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3715__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4115__o : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2934__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3715__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4113__o : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2935__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4586__o ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2936__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3715__o ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<2,0>().val()) : value<3>{0u})))))))).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3219 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3117$1273 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2894 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2953$1231 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2977$1243 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2967$1238
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3626__q.next = (p_rst ? value<2>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? value<2>{0x1u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3626__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2866__CMP ? (p_unity__link__inst_2e_bus__done ? value<2>{0x2u} : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o ? value<2>{0x2u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3626__q.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2867__CMP ? value<2>{0u} : value<2>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3218 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3119$1274 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2889 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2933$1221
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.next = (p_rst ? value<1>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3331 ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr) : value<1>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3217 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3121$1275 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2884 $auto$opt_reduce.cc:131:opt_pmux$3328 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2985$1247 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:2991$1250
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3499__o.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2867__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3544__o) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3499__o.curr) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2866__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3499__o.curr : value<1>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3216 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3123$1276 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2879 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2935$1222 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4148$1350 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:4146$1349 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:4144$1348 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2993$1251 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2987$1248
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3629__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue)) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3629__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2866__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3629__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2867__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3544__o ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3629__q.curr : value<1>{0u}) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3629__q.curr) : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3214 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3127$1278 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2869 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2979$1244 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2969$1239
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3631__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2866__CMP ? (p_unity__link__inst_2e_bus__done ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3631__q.curr : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3631__q.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2867__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3631__q.curr : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3213 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3129$1279 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2864 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$sub$top.v:2957$1233
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3632__q.next = (p_rst ? value<11>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP ? value<11>{0x3ffu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2866__CMP ? sub_uu<11>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3632__q.curr, value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2867__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3632__q.curr : value<11>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3212 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3105$1267 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2924 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2971$1240 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2959$1234 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2963$1236
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_access__failure.next = (p_rst ? value<4>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2866__CMP ? (p_unity__link__inst_2e_bus__done ? value<1>{0u}.concat((p_wb__err ? value<3>{0x4u} : value<3>{0u})).val() : value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o ? value<3>{0x5u} : value<3>{0u})).val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3339 ? p_unity__link__inst_2e_core__inst_2e_access__failure.curr : value<4>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3211 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3107$1268 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2919 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2973$1241
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3634__q.next = (p_rst ? value<8>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2866__CMP ? (p_unity__link__inst_2e_bus__done ? p_wb__dat__i : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3634__q.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3339 ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3634__q.curr : value<8>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3210 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3109$1269 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2914 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2945$1227 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2975$1242 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2965$1237
	if (posedge_p_clk) {
		p_wb__stb.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? value<1>{0x1u} : p_wb__stb.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2866__CMP ? (p_unity__link__inst_2e_bus__done ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3523__o ? value<1>{0u} : p_wb__stb.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2867__CMP ? p_wb__stb.curr : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3209 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3111$1270 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2909 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2947$1228 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:2941$1225
	if (posedge_p_clk) {
		p_wb__we.next = (p_rst ? value<1>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3331 ? p_wb__we.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__granted, p_unity__link__inst_2e_core__inst_2e_access__exclusive) : p_wb__we.curr) : value<1>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3208 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3113$1271 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2904 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2949$1229
	if (posedge_p_clk) {
		p_wb__adr.next = (p_rst ? value<8>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3331 ? p_wb__adr.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3344__q.curr.slice<38,31>().val() : p_wb__adr.curr) : value<8>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3207 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3115$1272 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2899 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2951$1230 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4154$1352 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4086$1327 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4084$1326
	if (posedge_p_clk) {
		p_wb__dat__o.next = (p_rst ? value<8>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3331 ? p_wb__dat__o.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? ((or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2195__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2198__o) ? value<1>{0x1u} : value<1>{0u}) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.curr : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.curr.slice<80,73>().val()) : p_wb__dat__o.curr) : value<8>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$3225 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$3174
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5165__data.next = (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5069__o ? i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_192_24_48__DATA : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5165__data.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$3226 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:166$39 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:120$16 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:116$14
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5164__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5102__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5069__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5164__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$3227 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:164$38 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:118$15
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.next = (p_rst ? value<10>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5102__o ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<24,15>().val() : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$3228 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:162$37 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:152$32 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:130$21 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$eq$top.v:128$20 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:146$29
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_sent__ready.next = (p_rst ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5109__o ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<8>{0xffu}) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_sent__ready.curr) : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5117__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_sent__ready.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$3229 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:160$36 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:150$31 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:140$26 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:144$28
	if (posedge_p_clk) {
		p_out__valid.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5109__o ? value<1>{0x1u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5099__o, p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5117__o) ? value<1>{0u} : p_out__valid.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$3230 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:158$35 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:148$30 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$add$top.v:126$19 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:142$27 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$sub$top.v:136$24
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5109__o ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<1>{0x1u}) : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5117__o ? sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$3231 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:156$34 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:104$8 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$add$top.v:102$7
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5157__q.next = (p_rst ? value<8>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5069__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5157__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5157__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$3232 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:154$33 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:100$6 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$add$top.v:98$5
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5156__q.next = (p_rst ? value<8>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5068__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5156__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5156__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procdff$3191 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7615$2125 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7602$2122 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7605$2123 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7608$2124
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2136__q.next = (p_rst ? value<118>{0x10u,0u,0u,0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2077__o.slice<117,103>().concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2079__o ? value<2>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2077__o.slice<102,101>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2077__o.slice<100,17>()).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2079__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2077__o.slice<16>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2077__o.slice<15,12>()).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2079__o ? value<12>{0x10u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2077__o.slice<11,0>().val())).val());
	}
	// \src: top.v:5690.3-5692.40
	// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procdff$3195
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_memory__word.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2158__data_5b_7_3a_0_5d_;
	}
	// \src: top.v:96.20-96.51
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:96$4
	p_out__data = (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5164__q.curr ? p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.curr.slice<7,0>().val() : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5165__data.curr.slice<7,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procdff$3221 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:772$132 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:770$131 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$3156 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:647$113 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$and$top.v:641$111 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:643$112 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:676$120 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$3149 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$sub$top.v:669$118 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$3142 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:633$108 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:629$107 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3299 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$3135 $auto$opt_reduce.cc:131:opt_pmux$3346 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$3128 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:541$88 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:637$109 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:661$117 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$gt$top.v:653$115 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$add$top.v:657$116 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$3121 $auto$opt_reduce.cc:131:opt_pmux$3326 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$procmux$3114 $auto$opt_reduce.cc:131:opt_pmux$3401 $auto$opt_reduce.cc:131:opt_pmux$3320 $flatten\unity_link_inst.\core_inst.\with_datalink_tx_datalink_tx_inst.$ternary$top.v:639$110
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.next = (p_rst ? value<26>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_advance ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3115__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3116__CMP).val()) ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<88>().val() ? value<1>{0x1u} : value<1>{0u}) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3117__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3118__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3119__CMP).val()) ? value<1>{0x1u} : value<1>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3119__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<14,13>().val() : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3115__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3116__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3117__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3118__CMP).val()) ? value<2>{0u} : value<2>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3115__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<88>().val() ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4817__o_5b_6_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<22,15>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3116__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<88>().val() ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<87,80>().val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<22,15>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3117__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<12,9>().val(), value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<12,9>().val())).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<12,9>()).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3118__CMP ? value<8>{0xdu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3119__CMP ? value<8>{0xau} : value<8>{0u})))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3116__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<92,91>().val() : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3115__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3117__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3118__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3119__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<14,13>().val() : value<2>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3115__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4899__o.slice<12,5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3116__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<88>().val() ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4940__o_5b_2_3a_0_5d_.slice<2>().concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4947__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4954__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4961__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4968__o_5b_2_3a_0_5d_.slice<2>()).concat((p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4933__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4968__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4968__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val())).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<12,5>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3117__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<8,5>().concat(value<4>{0u}).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3118__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<12,5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3119__CMP ? value<8>{0u} : value<8>{0u})))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3115__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4899__o.slice<4,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3116__CMP ? value<2>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3117__CMP ? sub_uu<2>(p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<4,3>().val(), value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3118__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<4,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3119__CMP ? value<2>{0u} : value<2>{0u})))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3115__CMP ? p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4899__o.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3116__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<89>().val(), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<88>().val()) ? value<2>{0x1u}.concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747__q.curr.slice<90>().val() ? value<1>{0x1u} : value<1>{0u})).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3117__CMP ? (p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n4813__o ? value<3>{0x4u} : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3118__CMP ? value<3>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_with__datalink__tx__datalink__tx__inst_2e__24_procmux_24_3119__CMP ? value<3>{0x1u} : value<3>{0u})))))).val() : p_unity__link__inst_2e_core__inst_2e_with__datalink__tx__datalink__tx__inst_2e_n5061__q.curr));
	}
	// cells $flatten\unity_link_inst.\wishbone_master_inst.$or$top.v:8865$2326 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:2925$1217 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:2923$1216 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$or$top.v:2921$1215
	p_wb__cyc = or_uu<1>(p_wb__stb.curr, and_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3499__o.curr, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3629__q.curr), not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3631__q.curr)));
	// connection
	p_out__flush = value<1>{0u};
	// connection
	p_wb__sel = value<1>{0x1u};
	return converged;
}

} // namespace cxxrtl_design

